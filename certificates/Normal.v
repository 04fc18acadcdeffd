(** Terms become fractions of polynomials in few atoms, and are compared by the normaliser of Coq's own [field]:
    modulo sin² = 1 − cos² for every angle and (√r)² = r for every root. Nothing here has to be believed: all is proved. *)
From Certificate Require Export Calculus.
Require Export Ring_polynom Field_theory RealField Field Lra Lia.

Notation fe := (FExpr Z).
Notation pe := (PExpr Z).
Notation ev := (FEeval 0 1 Rplus Rmult Rminus Ropp Rdiv Rinv IZR N.to_nat Rpow_def.pow).
Notation pv := (PEeval 0 1 Rplus Rmult Rminus Ropp IZR N.to_nat Rpow_def.pow).
Notation fnorm := (Fnorm 0%Z 1%Z Z.add Z.mul Z.sub Z.opp Zeq_bool).
Notation nsub := (norm_subst 0%Z 1%Z Z.add Z.mul Z.sub Z.opp Zeq_bool Z.quotrem).
Notation mlist := (mk_monpol_list 0%Z 1%Z Z.add Z.mul Z.sub Z.opp Zeq_bool Z.quotrem).
Notation rels l lpe := (interp_PElist 0 1 Rplus Rmult Rminus Ropp eq IZR N.to_nat Rpow_def.pow l lpe).
Definition peq := Peq Zeq_bool.
Definition rounds := 20%nat.

Lemma Rext : ring_eq_ext Rplus Rmult Ropp eq. Proof. constructor; congruence. Qed.
Lemma Rinvext : forall p q : R, p = q -> / p = / q. Proof. congruence. Qed.
Lemma AFR : almost_field_theory 0 1 Rplus Rmult Rminus Ropp Rdiv Rinv eq.
Proof. exact (F2AF (Eqsth R) Rext Rfield). Qed.
Lemma AR : almost_ring_theory 0 1 Rplus Rmult Rminus Ropp eq.
Proof. exact (Rth_ARth (Eqsth R) Rext (F_R Rfield)). Qed.
Lemma Zdiv : div_theory eq Z.add Z.mul IZR Z.quotrem.
Proof. constructor. intros a b. generalize (Z.quotrem_eq a b); case Z.quotrem; intros q r E. rewrite E. rewrite ?plus_IZR, ?mult_IZR. ring. Qed.

Lemma polynomials_equal l lpe p q :
  rels l lpe -> peq (nsub rounds (mlist lpe) p) (nsub rounds (mlist lpe) q) = true -> pv l p = pv l q.
Proof. intros H E. eapply (ring_correct (Eqsth R) Rext AR R_rm R_power_theory Zdiv rounds l lpe p q H E). Qed.

Lemma conditions_met l cs :
  Forall (fun k => pv l k <> 0) cs -> PCond 0 1 Rplus Rmult Rminus Ropp eq IZR N.to_nat Rpow_def.pow l cs.
Proof. induction 1; simpl; auto. destruct l0; auto. Qed.

Lemma fractions_equal l lpe a b :
  rels l lpe -> Forall (fun k => pv l k <> 0) (condition (fnorm a) ++ condition (fnorm b)) ->
  peq (nsub rounds (mlist lpe) (PEmul (num (fnorm a)) (denum (fnorm b))))
      (nsub rounds (mlist lpe) (PEmul (num (fnorm b)) (denum (fnorm a)))) = true ->
  ev l a = ev l b.
Proof.
  intros H K E.
  eapply (Field_correct (Eqsth R) Rext Rinvext AFR R_rm R_power_theory Zdiv rounds l lpe a b H eq_refl eq_refl eq_refl E).
  apply conditions_met. exact K.
Qed.

(** A fraction is its numerator over its denominator. *)
Lemma fraction_value l a :
  Forall (fun k => pv l k <> 0) (condition (fnorm a)) ->
  pv l (denum (fnorm a)) <> 0 /\ ev l a = pv l (num (fnorm a)) / pv l (denum (fnorm a)).
Proof.
  intros K. apply conditions_met in K. split.
  - apply (Pcond_Fnorm (Eqsth R) Rext AFR R_rm R_power_theory l a K).
  - apply (Fnorm_FEeval_PEeval (Eqsth R) Rext Rinvext AFR R_rm R_power_theory l a K).
Qed.

(** ** Atoms *)
Definition term_dec (s t : term) : {s = t} + {s <> t}.
Proof. decide equality; auto using Z.eq_dec, Pos.eq_dec, N.eq_dec, Nat.eq_dec. Defined.
Fixpoint place (table : list term) (t : term) (i : positive) : option positive :=
  match table with [] => None | u :: r => if term_dec u t then Some i else place r t (Pos.succ i) end.

Notation "'do' x <- e ; f" := (match e with Some x => f | None => None end) (at level 200, x pattern, right associativity).
Definition atom table t : option fe := do i <- place table t 1; if term_dec (BinList.nth (Num 0) i table) t then Some (FEX Z i) else None.

(** Sine and cosine of a sum, by those of its parts *)
Fixpoint multiple (n : nat) (sc : fe * fe) : fe * fe :=
  match n with
  | O => (FEc 0%Z, FEc 1%Z)
  | S n => let m := multiple n sc in
      (FEadd (FEmul (fst sc) (snd m)) (FEmul (snd sc) (fst m)), FEsub (FEmul (snd sc) (snd m)) (FEmul (fst sc) (fst m)))
  end.
Fixpoint circular table (t : term) : option (fe * fe) :=
  match t with
  | Num 0 => Some (FEc 0%Z, FEc 1%Z)
  | Add x y => do (s, c) <- circular table x; do (s', c') <- circular table y;
      Some (FEadd (FEmul s c') (FEmul c s'), FEsub (FEmul c c') (FEmul s s'))
  | Sub x y => do (s, c) <- circular table x; do (s', c') <- circular table y;
      Some (FEsub (FEmul s c') (FEmul c s'), FEadd (FEmul c c') (FEmul s s'))
  | Opp x => do (s, c) <- circular table x; Some (FEopp s, c)
  | Mul (Num (Zpos k)) x => do sc <- circular table x; Some (multiple (Pos.to_nat k) sc)
  | _ => do s <- atom table (Sin t); do c <- atom table (Cos t); Some (s, c)
  end.

Fixpoint flat table (t : term) : option fe :=
  match t with
  | Num z => Some (FEc z)
  | Add x y => do x <- flat table x; do y <- flat table y; Some (FEadd x y)
  | Sub x y => do x <- flat table x; do y <- flat table y; Some (FEsub x y)
  | Mul x y => do x <- flat table x; do y <- flat table y; Some (FEmul x y)
  | Div x y => do x <- flat table x; do y <- flat table y; Some (FEdiv x y)
  | Opp x => do x <- flat table x; Some (FEopp x)
  | Pow x n => do x <- flat table x; Some (FEpow x n)
  | Sin x => do (s, _) <- circular table x; Some s
  | Cos x => do (_, c) <- circular table x; Some c
  | _ => atom table t
  end.

(** ** The values of atoms, and of what is made of them *)
Lemma jump_map {A B} (f : A -> B) p : forall l, map f (BinList.jump p l) = BinList.jump p (map f l).
Proof. assert (T : forall l, map f (tl l) = tl (map f l)) by (intros [|]; reflexivity). induction p; intros l; simpl; rewrite ?IHp, ?T; auto. Qed.
Lemma nth_map {A B} (f : A -> B) d p : forall l, f (BinList.nth d p l) = BinList.nth (f d) p (map f l).
Proof.
  assert (T : forall l, map f (tl l) = tl (map f l)) by (intros [|]; reflexivity).
  induction p; intros l; simpl; rewrite ?IHp, ?jump_map, ?T; auto. destruct l; auto.
Qed.

Ltac split_options := repeat match goal with
  | H : match ?e with Some _ => _ | None => None end = Some _ |- _ => destruct e eqn:?; [|discriminate H]
  | H : (let (_, _) := ?e in _) = Some _ |- _ => destruct e eqn:?
  | H : Some _ = Some _ |- _ => injection H; clear H; intros; subst
  end.

Section Values.
  Variables (a : assignment) (table : list term).
  Notation l := (map (eval a) table).
  Lemma atom_value t x : atom table t = Some x -> ev l x = eval a t.
  Proof.
    unfold atom. intros H. split_options. destruct (term_dec _ t) as [<-|]; [|discriminate]. injection H as <-.
    simpl. symmetry. apply (nth_map (eval a) (Num 0)).
  Qed.
  Lemma multiple_value n s c x : ev l s = sin x -> ev l c = cos x ->
    ev l (fst (multiple n (s, c))) = sin (INR n * x) /\ ev l (snd (multiple n (s, c))) = cos (INR n * x).
  Proof.
    intros Hs Hc. induction n as [|n [IHs IHc]].
    - simpl. rewrite Rmult_0_l, sin_0, cos_0. auto.
    - rewrite S_INR. replace ((INR n + 1) * x) with (x + INR n * x) by ring.
      rewrite sin_plus, cos_plus, <- IHs, <- IHc, <- Hs, <- Hc. split; simpl; ring.
  Qed.
  Lemma circular_value t : forall s c, circular table t = Some (s, c) -> ev l s = sin (eval a t) /\ ev l c = cos (eval a t).
  Proof.
    assert (A : forall t s c, (do s <- atom table (Sin t); do c <- atom table (Cos t); Some (s, c)) = Some (s, c) ->
      ev l s = sin (eval a t) /\ ev l c = cos (eval a t)).
    { intros u s c H. split_options. split; [apply (atom_value (Sin u))|apply (atom_value (Cos u))]; assumption. }
    induction t; intros s c H; try (apply A; exact H).
    - destruct z; try (apply A; exact H). simpl in H. split_options. simpl. rewrite sin_0, cos_0. auto.
    - simpl in H. split_options. destruct (IHt1 _ _ eq_refl), (IHt2 _ _ eq_refl). simpl. rewrite sin_plus, cos_plus. split; congruence.
    - simpl in H. split_options. destruct (IHt1 _ _ eq_refl), (IHt2 _ _ eq_refl). simpl. rewrite sin_minus, cos_minus. split; congruence.
    - destruct t1; try (apply A; exact H). destruct z; try (apply A; exact H).
      simpl in H. destruct (circular table t2) as [[s' c']|] eqn:E; [|discriminate]. injection H as H.
      destruct (IHt2 _ _ eq_refl) as [E1 E2].
      pose proof (multiple_value (Pos.to_nat p) s' c' _ E1 E2) as [M1 M2]. rewrite H in M1, M2. simpl in M1, M2.
      rewrite INR_IZR_INZ, positive_nat_Z in M1, M2. simpl. auto.
    - simpl in H. split_options. destruct (IHt _ _ eq_refl). simpl. rewrite sin_neg, cos_neg. split; congruence.
  Qed.
  Lemma flat_value t : forall x, flat table t = Some x -> ev l x = eval a t.
  Proof.
    induction t; intros x H; simpl in H; try (apply atom_value; exact H);
      try (destruct (circular table t) as [[s c]|] eqn:E; [|discriminate]; injection H as <-; apply circular_value in E as [E1 E2]; assumption);
      split_options; simpl; rewrite ?(IHt1 _ eq_refl), ?(IHt2 _ eq_refl), ?(IHt _ eq_refl); reflexivity.
  Qed.
End Values.

(** All atoms of a term *)
Definition insert t table := if in_dec term_dec t table then table else t :: table.
Fixpoint angles (t : term) table := match t with
  | Num 0 => table
  | Add x y | Sub x y => angles x (angles y table)
  | Opp x | Mul (Num (Zpos _)) x => angles x table
  | _ => insert (Sin t) (insert (Cos t) table) end.
Fixpoint atoms (t : term) table := match t with
  | Num _ => table
  | Add x y | Sub x y | Mul x y | Div x y => atoms x (atoms y table)
  | Opp x | Pow x _ => atoms x table
  | Sin x | Cos x => angles x table
  | Sqrt x | App _ _ x => insert t (atoms x table)
  | Ang x y => insert t (atoms x (atoms y table))
  | _ => insert t table end.

(** sin² = 1 − cos² for the atoms of a table *)
Definition circle table (t : term) : option (pe * pe) := match t with
  | Sin x => do s <- atom table (Sin x); do c <- atom table (Cos x);
      match s, c with FEX _ i, FEX _ j => Some (PEpow (PEX Z i) 2, PEsub (PEc 1%Z) (PEpow (PEX Z j) 2)) | _, _ => None end
  | _ => None end.
Fixpoint somes {A} (l : list (option A)) := match l with [] => [] | Some x :: l => x :: somes l | None :: l => somes l end.
Definition circles table := somes (map (circle table) table).
Definition holds_at l (r : pe * pe) := pv l (fst r) = pv l (snd r).
Lemma rels_Forall l lpe : Forall (holds_at l) lpe -> rels l lpe.
Proof. induction 1 as [|[p q] lpe H F IH]; simpl; auto. destruct lpe; [exact H|split; [exact H|exact IH]]. Qed.
Lemma Forall_somes {A} (P : A -> Prop) l : (forall x, In (Some x) l -> P x) -> Forall P (somes l).
Proof. induction l as [|[x|] l IH]; simpl; intros H; auto. Qed.
Lemma circles_right a table : Forall (holds_at (map (eval a) table)) (circles table).
Proof.
  apply Forall_somes. intros r H. apply in_map_iff in H. destruct H as (t & H & _). destruct t; try discriminate.
  simpl in H. split_options. destruct f as [| |?|i| | | | | | |], f0 as [| |?|j| | | | | | |]; try discriminate. injection H as <-.
  unfold holds_at. cbn [fst snd PEeval N.to_nat Pos.to_nat Pos.iter_op].
  pose proof (atom_value a table (Sin t) _ Heqo) as E1. pose proof (atom_value a table (Cos t) _ Heqo0) as E2. simpl in E1, E2.
  change (Pos.to_nat 2) with 2%nat. rewrite E1, E2. generalize (sin2_cos2 (eval a t)). unfold Rsqr. intros. simpl. lra.
Qed.
