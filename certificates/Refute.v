(** Refutations: an assignment, made of fractions, that satisfies everything that is assumed, and under which both
    sides have values that differ. *)
From Certificate Require Export Check Analysis.
Require Export QArith. Require Import Qreals Psatz.
Local Open Scope R_scope.
Local Arguments Qred : simpl never. Local Arguments Qplus : simpl never. Local Arguments Qminus : simpl never. Local Arguments Qmult : simpl never.
Local Arguments Qopp : simpl never. Local Arguments Qinv : simpl never. Local Arguments Qdiv : simpl never. Local Arguments Qpower : simpl never.

Definition differs a x y :=
  same_shape (entries x) (entries y) = true /\ Forall (met a) (needs x ++ needs y) /\ value a x <> value a y.
Definition not_below a x y :=
  comparable x y /\ Forall (met a) (needs x ++ needs y) /\ eval a (fst (single y)) <= eval a (fst (single x)).
Definition is_above a x y :=
  comparable x y /\ Forall (met a) (needs x ++ needs y) /\ eval a (fst (single y)) < eval a (fst (single x)).
(** There is an assignment with smooth functions that satisfies the hypotheses and the statement. *)
Definition possible (branches : list term) (hypotheses : list need) (statement : assignment -> Prop) :=
  exists a, smooth a /\ along branches a /\ Forall (met a) hypotheses /\ statement a.

(** ** An angle with a rational cosine and sine *)
Definition angle_with (c s : R) := if Rle_dec 0 s then acos c else - acos c.
Lemma angle_with_right c s : c * c + s * s = 1 -> cos (angle_with c s) = c /\ sin (angle_with c s) = s.
Proof.
  intros H. assert (Hc : -1 <= c <= 1) by (split; nra). unfold angle_with. destruct (Rle_dec 0 s) as [P|P].
  - split; [apply cos_acos; exact Hc|]. rewrite sin_acos by exact Hc. replace (1 - c²) with (s * s) by (unfold Rsqr; lra). apply sqrt_square. exact P.
  - rewrite cos_neg, sin_neg. split; [apply cos_acos; exact Hc|]. rewrite sin_acos by exact Hc.
    replace (1 - c²) with ((- s) * (- s)) by (unfold Rsqr; lra). rewrite sqrt_square; lra.
Qed.

(** ** A smooth function with given derivatives at a place *)
Fixpoint powers (n : nat) (vs : list R) (h : R) : R := match vs with [] => 0 | v :: vs => v * (h ^ n / INR (fact n)) + powers (S n) vs h end.
Lemma powers_derivative vs : forall n h, is_derivative (powers (S n) vs) h (powers n vs h).
Proof.
  induction vs as [|v vs IH]; intros n h; simpl powers.
  - exact (derivable_pt_lim_const 0 h).
  - apply (derivable_pt_lim_plus (fun h => v * (h ^ S n / INR (fact (S n)))) (powers (S (S n)) vs)); [|apply IH].
    eapply derivative_ext; [| |exact (derivable_pt_lim_scal (fun h => h ^ S n) (v / INR (fact (S n))) h _ (derivable_pt_lim_pow h (S n)))].
    + intros z. unfold mult_real_fct, Rdiv. ring.
    + change (fact (S n)) with (S n * fact n)%nat. rewrite mult_INR. simpl pred. field. split; [apply INR_fact_neq_0|apply not_0_INR; discriminate].
Qed.
Lemma powers_at_0 vs : powers 0 vs 0 = hd 0 vs.
Proof.
  assert (Z : forall vs n, powers (S n) vs 0 = 0). { intros us. induction us as [|u us IH]; intros n; simpl; [reflexivity|]. rewrite IH. unfold Rdiv. ring. }
  destruct vs as [|v vs]; simpl; [reflexivity|]. rewrite Z. field.
Qed.
Lemma tail_derivative vs h : is_derivative (powers 0 vs) h (powers 0 (tl vs) h).
Proof.
  destruct vs as [|v vs]; simpl tl.
  - exact (derivable_pt_lim_const 0 h).
  - eapply derivative_ext; [| |exact (derivable_pt_lim_plus (fun _ => v) (powers 1 vs) h _ _ (derivable_pt_lim_const v h) (powers_derivative vs 0 h))].
    + intros z. unfold plus_fct. simpl. field.
    + ring.
Qed.

Lemma tl_skipn {A} k : forall l : list A, tl (skipn k l) = skipn (S k) l.
Proof. induction k; intros [|x l]; auto. exact (IHk l). Qed.

(** ** Points *)
Record point := Point {
  numbers : list (positive * Q);                      (* constants *)
  circle_points : list (positive * (Q * Q));          (* constant angles, by cosine and sine *)
  motions : list ((positive * nat) * Q);              (* coordinates and their rates *)
  turns_ : list (positive * (Q * Q));                 (* coordinates that are angles, by cosine and sine *)
  values_of : list (positive * (term * list Q)) }.    (* functions: a place, the value and the derivatives there *)
Fixpoint look {A B} (same : A -> A -> bool) (l : list (A * B)) (x : A) : option B :=
  match l with [] => None | (y, v) :: l => if same x y then Some v else look same l x end.
Definition same_motion (x y : positive * nat) := Pos.eqb (fst x) (fst y) && Nat.eqb (snd x) (snd y).
Definition on_circle (p : Q * Q) := Qeq_bool (fst p * fst p + snd p * snd p) 1.
Definition sound (p : point) := forallb (fun e => on_circle (snd e)) (circle_points p) && forallb (fun e => on_circle (snd e)) (turns_ p).
Section Points.
  Variables (p : point) (branches : list term).
  Definition base : assignment := Assignment
    (fun i => match look Pos.eqb (numbers p) i with Some q => Q2R q
      | None => match look Pos.eqb (circle_points p) i with Some (c, s) => angle_with (Q2R c) (Q2R s) | None => 0 end end)
    (fun i k => match look same_motion (motions p) (i, k) with Some q => Q2R q
      | None => match k, look Pos.eqb (turns_ p) i with O, Some (c, s) => angle_with (Q2R c) (Q2R s) | _, _ => 0 end end)
    (fun _ _ _ => 0) (fun _ _ => 0).
  (** What has no function and no angle of a vector *)
  Fixpoint plain_term (t : term) : bool := match t with
    | Num _ | Const _ | Coord _ _ => true
    | Add s t | Sub s t | Mul s t | Div s t => plain_term s && plain_term t
    | Opp t | Pow t _ | Sin t | Cos t | Sqrt t => plain_term t
    | App _ _ _ | Ang _ _ => false end.
  Definition assigned : assignment := Assignment (constant base) (coordinate base)
    (fun f k x => match look Pos.eqb (values_of p) f with Some (r, vs) => powers 0 (skipn k (map Q2R vs)) (x - eval base r) | None => 0 end)
    (near (eval base (hd (Num 0) branches))).
  Lemma plain_right t : plain_term t = true -> eval assigned t = eval base t.
  Proof. induction t; simpl; intros H; try apply andb_prop in H as [H1 H2]; rewrite ?IHt1, ?IHt2, ?IHt by assumption; try reflexivity; discriminate. Qed.
  Lemma assigned_smooth : smooth assigned.
  Proof.
    intros f k x. simpl. destruct (look Pos.eqb (values_of p) f) as [[r vs]|]; [|exact (derivable_pt_lim_const 0 x)].
    set (us := map Q2R vs). change (is_derivative (fun x => powers 0 (skipn k us) (x - eval base r)) x (powers 0 (skipn (S k) us) (x - eval base r))).
    assert (T : tl (skipn k us) = skipn (S k) us) by apply tl_skipn.
    pose proof (tail_derivative (skipn k us) (x - eval base r)) as TD. rewrite T in TD.
    eapply derivative_ext; [reflexivity| |
      exact (derivable_pt_lim_comp (fun x => x - eval base r) (powers 0 (skipn k us)) x _ _
        (derivable_pt_lim_minus (fun x => x) (fun _ => eval base r) x 1 0 (derivable_pt_lim_id x) (derivable_pt_lim_const _ x)) TD)].
    ring.
  Qed.
  Definition one_direction := Nat.leb (length branches) 1 && forallb plain_term branches.
  Lemma assigned_along : one_direction = true -> along branches assigned.
  Proof.
    unfold one_direction, along. intros H. apply andb_prop in H as [L F]. apply Forall_forall. intros b I w W.
    assert (E : hd (Num 0) branches = b). { destruct branches as [|c [|? ?]]; simpl in *; try discriminate; destruct I; auto; contradiction. }
    rewrite forallb_forall in F. rewrite (plain_right b (F b I)). simpl. rewrite E. apply near_along. exact W.
  Qed.

  (** Values of atoms and of terms, as fractions *)
  (** An angle is told by its measure or by its cosine and its sine. *)
  Definition turn i := match look Pos.eqb (numbers p) i with Some _ => None | None => look Pos.eqb (circle_points p) i end.
  Definition moving_turn i := match look same_motion (motions p) (i, O) with Some _ => None | None => look Pos.eqb (turns_ p) i end.
  Definition leaf_number (t : term) : option Q := match t with
    | Const i => look Pos.eqb (numbers p) i
    | Coord i k => look same_motion (motions p) (i, k)
    | Sin (Const i) => option_map snd (turn i)
    | Cos (Const i) => option_map fst (turn i)
    | Sin (Coord i O) => option_map snd (moving_turn i)
    | Cos (Coord i O) => option_map fst (moving_turn i)
    | App f k t => match look Pos.eqb (values_of p) f with
        | Some (r, vs) => if term_dec t r then if plain_term r then Some (nth k vs 0%Q) else None else None | None => None end
    | _ => None end.
  (** A root is told if it is a fraction, too. *)
  Definition root_number (q : Q) : option Q :=
    let r := (Z.sqrt (Qnum q) # Z.to_pos (Z.sqrt (Zpos (Qden q))))%Q in if Qle_bool 0 r && Qeq_bool (r * r) q then Some r else None.
  Fixpoint direct_number (t : term) : option Q := match t with
    | Num z => Some (inject_Z z)
    | Add x y => do u <- direct_number x; do v <- direct_number y; Some (Qred (u + v))
    | Sub x y => do u <- direct_number x; do v <- direct_number y; Some (Qred (u - v))
    | Mul x y => do u <- direct_number x; do v <- direct_number y; Some (Qred (u * v))
    | Div x y => do u <- direct_number x; do v <- direct_number y; if Qeq_bool v 0 then None else Some (Qred (u / v))
    | Opp x => do u <- direct_number x; Some (Qopp u)
    | Pow x n => do u <- direct_number x; Some (Qred (Qpower u (Z.of_N n)))
    | Sqrt x => do u <- direct_number x; root_number (Qred u)
    | _ => leaf_number t end.
  Definition atom_number (t : term) : option Q := match t with Sqrt _ => direct_number t | _ => leaf_number t end.
  (** An atom without a fraction is 0 in no term that is looked at. *)
  Definition numbers_of (table : list term) := map atom_number table.
  Fixpoint fraction_value_of (env : list (option Q)) (x : fe) : option Q := match x with
    | FEO => Some 0%Q | FEI => Some 1%Q | FEc z => Some (inject_Z z)
    | FEX _ i => BinList.nth None i env
    | FEadd x y => do u <- fraction_value_of env x; do v <- fraction_value_of env y; Some (Qred (u + v))
    | FEsub x y => do u <- fraction_value_of env x; do v <- fraction_value_of env y; Some (Qred (u - v))
    | FEmul x y => do u <- fraction_value_of env x; do v <- fraction_value_of env y; Some (Qred (u * v))
    | FEopp x => do u <- fraction_value_of env x; Some (Qopp u)
    | FEinv x => do u <- fraction_value_of env x; if Qeq_bool u 0 then None else Some (Qred (/ u))
    | FEdiv x y => do u <- fraction_value_of env x; do v <- fraction_value_of env y; if Qeq_bool v 0 then None else Some (Qred (u / v))
    | FEpow x n => do u <- fraction_value_of env x; Some (Qred (Qpower u (Z.of_N n)))
    end.
  Definition number_of table t := do x <- flat table t; fraction_value_of (numbers_of table) x.

  Hypothesis Sound : sound p = true.
  Lemma circle_right l i c s : forallb (fun e => on_circle (snd e)) l = true -> look Pos.eqb l i = Some (c, s) ->
    cos (angle_with (Q2R c) (Q2R s)) = Q2R c /\ sin (angle_with (Q2R c) (Q2R s)) = Q2R s.
  Proof.
    intros F L. apply angle_with_right. rewrite <- !Q2R_mult, <- Q2R_plus. replace 1 with (Q2R 1) by (unfold Q2R; simpl; lra). apply Qeq_eqR.
    induction l as [|[j v] l IH]; simpl in *; [discriminate|]. apply andb_prop in F as [F1 F2]. destruct (Pos.eqb i j).
    - injection L as ->. apply Qeq_bool_eq. exact F1.
    - apply IH; assumption.
  Qed.
  Lemma turn_right i c s : turn i = Some (c, s) -> cos (eval assigned (Const i)) = Q2R c /\ sin (eval assigned (Const i)) = Q2R s.
  Proof.
    unfold sound in Sound. apply andb_prop in Sound as [S1 S2]. unfold turn. simpl. destruct (look Pos.eqb (numbers p) i); [discriminate|].
    intros L. rewrite L. apply (circle_right _ _ _ _ S1 L).
  Qed.
  Lemma moving_turn_right i c s : moving_turn i = Some (c, s) -> cos (eval assigned (Coord i 0)) = Q2R c /\ sin (eval assigned (Coord i 0)) = Q2R s.
  Proof.
    unfold sound in Sound. apply andb_prop in Sound as [S1 S2]. unfold moving_turn. simpl. destruct (look same_motion (motions p) (i, O)); [discriminate|].
    intros L. rewrite L. apply (circle_right _ _ _ _ S2 L).
  Qed.
  Lemma leaf_number_right t q : leaf_number t = Some q -> eval assigned t = Q2R q.
  Proof.
    assert (Z0 : Q2R 0 = 0) by (unfold Q2R; simpl; lra).
    destruct t; simpl; try discriminate.
    - intros ->. reflexivity.
    - intros ->. reflexivity.
    - destruct t; try discriminate; simpl.
      + destruct (turn p0) as [[c s]|] eqn:L; [|discriminate]. intros H. injection H as <-. apply (turn_right _ _ _ L).
      + destruct k; [|discriminate]. destruct (moving_turn p0) as [[c s]|] eqn:L; [|discriminate]. intros H. injection H as <-. apply (moving_turn_right _ _ _ L).
    - destruct t; try discriminate; simpl.
      + destruct (turn p0) as [[c s]|] eqn:L; [|discriminate]. intros H. injection H as <-. apply (turn_right _ _ _ L).
      + destruct k; [|discriminate]. destruct (moving_turn p0) as [[c s]|] eqn:L; [|discriminate]. intros H. injection H as <-. apply (moving_turn_right _ _ _ L).
    - destruct (look Pos.eqb (values_of p) f) as [[r vs]|]; [|discriminate]. destruct (term_dec t r) as [->|]; [|discriminate].
      destruct (plain_term r) eqn:P; [|discriminate]. intros H. injection H as <-. rewrite (plain_right r P), Rminus_diag_eq, powers_at_0 by reflexivity.
      clear - Z0. revert vs. induction k; intros [|v vs]; simpl; auto.
  Qed.
  Lemma red_right q : Q2R (Qred q) = Q2R q. Proof. apply Qeq_eqR, Qred_correct. Qed.
  Lemma power_right q n : Q2R (Qpower q (Z.of_N n)) = Q2R q ^ N.to_nat n.
  Proof.
    symmetry. destruct n as [|n]; [change (1 = Q2R 1); unfold Q2R; simpl; lra|].
    change (Q2R q ^ Pos.to_nat n = Q2R (Qpower_positive q n)). unfold Qpower_positive.
    induction n using Pos.peano_ind; [change (Q2R q * 1 = Q2R q); ring|]. rewrite Pos2Nat.inj_succ. simpl Rpow_def.pow. rewrite IHn, <- Q2R_mult. apply Qeq_eqR.
    symmetry. apply (pow_pos_succ Q_Setoid); [exact Qmult_comp|exact Qmult_assoc].
  Qed.
  Lemma root_number_right q r : root_number q = Some r -> sqrt (Q2R q) = Q2R r.
  Proof.
    unfold root_number. set (s := (Z.sqrt _ # _)%Q). destruct (Qle_bool 0 s && Qeq_bool (s * s) q)%bool eqn:E; [|discriminate].
    intros H. injection H as <-. apply andb_prop in E as [P E]. apply Qle_bool_iff, Qle_Rle in P. apply Qeq_bool_eq, Qeq_eqR in E.
    rewrite <- E, Q2R_mult. apply sqrt_square. replace 0 with (Q2R 0) by (unfold Q2R; simpl; lra). exact P.
  Qed.
  Lemma direct_number_right t : forall q, direct_number t = Some q -> eval assigned t = Q2R q.
  Proof.
    assert (N : forall q, Qeq_bool q 0 = false -> ~ (q == 0)%Q) by (intros q E H; apply Qeq_eq_bool in H; congruence).
    induction t; intros q H; try exact (leaf_number_right _ _ H); simpl in H; split_options; simpl eval.
    - unfold Q2R. simpl. lra.
    - rewrite red_right, Q2R_plus, (IHt1 _ eq_refl), (IHt2 _ eq_refl). reflexivity.
    - rewrite red_right, Q2R_minus, (IHt1 _ eq_refl), (IHt2 _ eq_refl). reflexivity.
    - rewrite red_right, Q2R_mult, (IHt1 _ eq_refl), (IHt2 _ eq_refl). reflexivity.
    - destruct (Qeq_bool q1 0) eqn:E; [discriminate|]. injection H as <-. rewrite red_right, Q2R_div by (apply N; exact E). rewrite (IHt1 _ eq_refl), (IHt2 _ eq_refl). reflexivity.
    - rewrite Q2R_opp, (IHt _ eq_refl). reflexivity.
    - rewrite red_right, power_right, (IHt _ eq_refl). reflexivity.
    - rewrite (IHt _ eq_refl), <- (red_right q0). apply root_number_right. exact H.
  Qed.
  Lemma atom_number_right t q : atom_number t = Some q -> eval assigned t = Q2R q.
  Proof. destruct t; try exact (leaf_number_right _ q). exact (direct_number_right _ q). Qed.
  Lemma fraction_value_right table x : forall q, fraction_value_of (numbers_of table) x = Some q -> ev (map (eval assigned) table) x = Q2R q.
  Proof.
    assert (R : forall q, Q2R (Qred q) = Q2R q) by (intros; apply Qeq_eqR, Qred_correct).
    assert (N : forall q, Qeq_bool q 0 = false -> ~ (q == 0)%Q) by (intros q E H; apply Qeq_eq_bool in H; congruence).
    induction x; simpl; intros q H; split_options.
    - unfold Q2R. simpl. lra.
    - unfold Q2R. simpl. lra.
    - unfold Q2R. simpl. lra.
    - unfold numbers_of in H.
      assert (G : forall t, BinList.nth None p0 (map atom_number table) = Some q -> BinList.nth (Num 0) p0 table = t -> eval assigned t = Q2R q).
      { intros t E <-. change (@None Q) with (atom_number (Ang (Num 0) (Num 0))) in E. rewrite <- nth_map in E.
        destruct (atom_number_right _ _ E) as []. f_equal.
        clear - E. revert table E. assert (T : forall (l : list term) d d', forall i, BinList.nth d i l = BinList.nth d' i l \/ BinList.nth d i l = d).
        { intros l d d' i. revert l. induction i; intros l; simpl; auto. destruct l; simpl; auto. }
        intros table E. destruct (T table (Ang (Num 0) (Num 0)) (Num 0) p0) as [->|X]; [reflexivity|]. rewrite X in E. discriminate. }
      rewrite <- (G _ H eq_refl). symmetry. apply (nth_map (eval assigned) (Num 0)).
    - rewrite R, Q2R_plus. rewrite (IHx1 _ eq_refl), (IHx2 _ eq_refl). reflexivity.
    - rewrite R, Q2R_minus. rewrite (IHx1 _ eq_refl), (IHx2 _ eq_refl). reflexivity.
    - rewrite R, Q2R_mult. rewrite (IHx1 _ eq_refl), (IHx2 _ eq_refl). reflexivity.
    - rewrite Q2R_opp. rewrite (IHx _ eq_refl). reflexivity.
    - destruct (Qeq_bool q0 0) eqn:E; [discriminate|]. injection H as <-. rewrite R, Q2R_inv by (apply N; exact E). rewrite (IHx _ eq_refl). reflexivity.
    - destruct (Qeq_bool q1 0) eqn:E; [discriminate|]. injection H as <-. rewrite R, Q2R_div by (apply N; exact E). rewrite (IHx1 _ eq_refl), (IHx2 _ eq_refl). reflexivity.
    - rewrite R, power_right, (IHx _ eq_refl). reflexivity.
  Qed.
  Lemma number_right table t q : number_of table t = Some q -> eval assigned t = Q2R q.
  Proof.
    unfold number_of. destruct (flat table t) as [x|] eqn:E; [|discriminate]. intros H. rewrite <- (flat_value assigned table t x E). apply fraction_value_right. exact H.
  Qed.

  Definition meets_point table n : bool := match number_of table (about n), n with
    | Some q, NonZero _ => negb (Qeq_bool q 0) | Some q, Positive _ => negb (Qle_bool q 0) | Some q, NonNegative _ => Qle_bool 0 q | None, _ => false end%bool.
End Points.

Lemma meets_point_right p branches table n : sound p = true -> meets_point p table n = true -> met (assigned p branches) n.
Proof.
  intros S. unfold meets_point. destruct (number_of p table (about n)) as [q|] eqn:E; [|destruct n; discriminate].
  apply (number_right p branches S) in E. assert (Z : Q2R 0 = 0) by (unfold Q2R; simpl; lra).
  destruct n; simpl in *; rewrite E; intros H.
  - intros X. rewrite <- Z in X. apply eqR_Qeq in X. apply Qeq_eq_bool in X. rewrite X in H. discriminate.
  - rewrite <- Z. apply Qlt_Rlt. apply Qnot_le_lt. intros X. apply Qle_bool_iff in X. rewrite X in H. discriminate.
  - rewrite <- Z. apply Qle_Rle, Qle_bool_iff. exact H.
Qed.
Lemma pairs_equal a m : forall n l, pairs m n = Some l -> map (map (cvalue a)) m = map (map (cvalue a)) n ->
  Forall (fun e => eval a (fst e) = eval a (snd e)) l.
Proof.
  induction m as [|r m IH]; destruct n as [|s n]; simpl; intros l E F; try discriminate; [injection E as <-; constructor|].
  destruct (paired r s) as [k|] eqn:P; [|discriminate]. destruct (pairs m n) as [k'|] eqn:Q; [|discriminate].
  injection E as <-. injection F as F1 F2. apply Forall_app. split; [|eapply IH; eauto].
  clear - P F1. revert s k P F1. induction r as [|c r IH]; destruct s as [|d s]; simpl; intros k P F; try discriminate; [injection P as <-; constructor|].
  destruct (paired r s) as [k'|] eqn:E; [|discriminate]. injection P as <-. simpl. unfold cvalue in F. injection F as F1 F2 F3.
  constructor; [exact F1|]. constructor; [exact F2|]. eapply IH; eauto.
Qed.

Section Checks.
  Variables (p : point) (branches : list term) (hypotheses : list need) (references : list term).
  (** A hypothesis that says nothing was not understood: nothing is refuted under it. *)
  Definition says_something n := match n with Positive (Num 1) => false | _ => true end.
  Definition satisfied :=
    sound p &&& one_direction branches &&& forallb says_something hypotheses &&& (let t := table_of (map about hypotheses) in forallb (meets_point p t) hypotheses).
  Definition all_met ns := let f := form branches hypotheses references (map about ns) in
    let ns := map (need_map f) ns in let t := table_of (map about ns) in forallb (meets_point p t) ns.
  Definition unequal (e : term * term) := let f := form branches hypotheses references [fst e; snd e] in
    let u := f (fst e) in let v := f (snd e) in let t := table_of [u; v] in
    match number_of p t u, number_of p t v with Some q, Some r => negb (Qeq_bool q r) | _, _ => false end.
  Notation a := (assigned p branches).
  Lemma satisfied_right : satisfied = true -> sound p = true /\ along branches a /\ Forall (met a) hypotheses.
  Proof.
    unfold satisfied. intros H. apply both_true in H as [H H3]. apply both_true in H as [H _]. apply both_true in H as [H1 H2]. split; [exact H1|]. split; [apply assigned_along; exact H2|].
    rewrite forallb_forall in H3. apply Forall_forall. intros n N. eapply meets_point_right; [exact H1|]. apply H3. exact N.
  Qed.
  Lemma all_met_right ns : satisfied = true -> all_met ns = true -> Forall (met a) ns.
  Proof.
    intros S H. apply satisfied_right in S as (S & B & F). unfold all_met in H. rewrite forallb_forall in H. apply Forall_forall. intros n N.
    apply (form_met branches hypotheses a B F references (map about ns)). eapply meets_point_right; [exact S|]. apply H. apply in_map. exact N.
  Qed.
  Lemma unequal_right e : satisfied = true -> unequal e = true -> eval a (fst e) <> eval a (snd e).
  Proof.
    intros S H E. apply satisfied_right in S as (S & B & F). unfold unequal in H.
    set (f := form branches hypotheses references [fst e; snd e]) in *. set (t := table_of _) in *.
    destruct (number_of p t (f (fst e))) as [q|] eqn:E1; [|discriminate]. destruct (number_of p t (f (snd e))) as [r|] eqn:E2; [|discriminate].
    apply (number_right p branches S) in E1. apply (number_right p branches S) in E2. unfold f in E1, E2.
    rewrite (form_right branches hypotheses a B F) in E1, E2. rewrite E1, E2 in E. apply eqR_Qeq, Qeq_eq_bool in E. rewrite E in H. discriminate.
  Qed.
  Definition check_differs x y := satisfied &&& same_shape (entries x) (entries y) &&& all_met (needs x ++ needs y) &&&
    match pairs (entries x) (entries y) with Some l => existsb unequal l | None => false end.
  Theorem differs_by_point x y : check_differs x y = true -> possible branches hypotheses (fun a => differs a x y).
  Proof.
    intros H. unfold check_differs in H. apply both_true in H as [H H4]. apply both_true in H as [H H3]. apply both_true in H as [H1 H2].
    exists a. split; [apply assigned_smooth|]. destruct (satisfied_right H1) as (S & B & F). split; [exact B|]. split; [exact F|].
    split; [exact H2|]. split; [apply all_met_right; assumption|]. destruct (pairs _ _) as [l|] eqn:P; [|discriminate].
    apply existsb_exists in H4 as (e & I & U). apply (unequal_right e H1) in U. intros V. apply U.
    pose proof (pairs_equal a _ _ _ P V) as G. rewrite Forall_forall in G. exact (G e I).
  Qed.
  Definition check_point_order n x y := satisfied &&& (is_scalar x && is_scalar y && is_real (single x) && is_real (single y)) &&&
    all_met (n (sub (fst (single x)) (fst (single y))) :: needs x ++ needs y).
  Theorem not_below_by_point x y : check_point_order NonNegative x y = true -> possible branches hypotheses (fun a => not_below a x y).
  Proof.
    intros H. unfold check_point_order in H. apply both_true in H as [H H3]. apply both_true in H as [H1 H2].
    exists a. split; [apply assigned_smooth|]. destruct (satisfied_right H1) as (S & B & F). split; [exact B|]. split; [exact F|].
    apply (all_met_right _ H1) in H3. pose proof (Forall_inv H3) as N1. apply Forall_inv_tail in H3. simpl in N1. rewrite eval_sub in N1.
    split; [exact H2|]. split; [exact H3|]. lra.
  Qed.
  Theorem is_above_by_point x y : check_point_order Positive x y = true -> possible branches hypotheses (fun a => is_above a x y).
  Proof.
    intros H. unfold check_point_order in H. apply both_true in H as [H H3]. apply both_true in H as [H1 H2].
    exists a. split; [apply assigned_smooth|]. destruct (satisfied_right H1) as (S & B & F). split; [exact B|]. split; [exact F|].
    apply (all_met_right _ H1) in H3. pose proof (Forall_inv H3) as N1. apply Forall_inv_tail in H3. simpl in N1. rewrite eval_sub in N1.
    split; [exact H2|]. split; [exact H3|]. lra.
  Qed.
End Checks.

(** ** Points in the words of a document *)
Inductive setting :=
  | Is (x : expr) (q : Q)                 (* a quantity, or a rate *)
  | IsComplex (x : expr) (q r : Q)        (* a complex quantity, by its real and imaginary part *)
  | Turns (x : expr) (c s : Q)            (* an angle, by its cosine and its sine *)
  | Takes (f : expr) (vs : list Q).       (* a function: its value and derivatives at its place *)
Arguments Is x q%Q. Arguments IsComplex x (q r)%Q. Arguments Turns x (c s)%Q.
Definition put_in (s : setting) (p : point) : point := let '(Point n c m t v) := p in
  match s with
  | Is x q => match fst (single x) with
      | Const i => Point ((i, q) :: n) c m t v | Coord i k => Point n c (((i, k), q) :: m) t v | _ => p end
  | IsComplex x q r => match single x with (Const i, Const j) => Point ((i, q) :: (j, r) :: n) c m t v | _ => p end
  | Turns x a b => match fst (single x) with
      | Const i => Point n ((i, (a, b)) :: c) m t v | Coord i O => Point n c m ((i, (a, b)) :: t) v | _ => p end
  | Takes f vs => match fst (single f) with App g O r => Point n c m t ((g, (r, vs)) :: v) | _ => p end
  end.
Definition point_of (l : list setting) := fold_right put_in (Point [] [] [] [] []) l.
Ltac by_point_rule l references := lazymatch goal with
  | |- possible ?b ?h (fun a => differs a ?x ?y) => apply (differs_by_point (point_of l) b h references x y)
  | |- possible ?b ?h (fun a => not_below a ?x ?y) => apply (not_below_by_point (point_of l) b h references x y)
  | |- possible ?b ?h (fun a => is_above a ?x ?y) => apply (is_above_by_point (point_of l) b h references x y) end.
Ltac by_point l references := by_point_rule l references; vm_cast_no_check (eq_refl true).
Ltac accepts_point l references := by_point_rule l references; vm_compute; reflexivity.
