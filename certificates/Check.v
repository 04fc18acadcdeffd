(** The checker: a boolean function, and the theorem that what it accepts is so. *)
From Certificate Require Export Rewrite.

(** ** What is known from the hypotheses *)
Definition learn_one K n : list (sign * pe) := match fraction_of K (about n) with
  | Some (p, PEc 1%Z) => [(sign_needed n, p)]
  | Some (p, q) => [(sign_needed n, PEmul p q)]
  | None => [] end.
Definition with_facts K fs := Knowledge (table K) (relations K) (rules K) (facts K ++ fs) (divisors K) (factors K).
Definition ready K := Knowledge (table K) (relations K) (rules K) (facts K) (divisors K) (find_factors K).
Fixpoint learn K (hypotheses : list need) := match hypotheses with [] => K | n :: l => learn (with_facts K (learn_one K n)) l end.
Definition from_atoms ts hints := let c := circles ts in Knowledge ts c (mlist c) [] hints [].
Definition polynomials table (ts : list term) := somes (map (fun t => do x <- flat table t; Some (num (fnorm x))) ts).
(** The square of a root, and that it is not negative *)
Definition one_root K t : list (pe * pe) * list (sign * pe) := match t with
  | Sqrt x => match atom (table K) t, fraction_of K x with
      | Some (FEX _ i), Some (p, PEc 1%Z) =>
          if proves K NotBelow p then ([(PEpow (PEX Z i) 2, p)], [(if proves K Above p then Above else NotBelow, PEX Z i)]) else ([], [])
      | _, _ => ([], []) end
  | _ => ([], []) end.
Definition with_roots K := let l := map (one_root K) (table K) in
  let r := relations K ++ flat_map fst l in
  Knowledge (table K) r (mlist r) (facts K ++ flat_map snd l) (divisors K) [].
(** Hypotheses about other quantities are left out. *)
Definition known_here table (n : need) := forallb (fun t => if in_dec term_dec t table then true else false) (atoms (about n) []).
Definition relevant table := filter (known_here table).

(** ** The checker *)
Definition terms_of (ns : list need) (es : list (term * term)) := map about ns ++ flat_map (fun e => [fst e; snd e]) es.
Definition table_of ts := fold_right atoms [] ts.
Section Decision.
  Variables (branches : list term) (hypotheses : list need) (hints : list term).
  Definition first_knowledge ts :=
    let t := table_of (ts ++ flat_map (fun b => [b; Sin b]) branches) in
    ready (learn (from_atoms t []) (relevant t hypotheses)).
  (** Terms in the form in which they are compared *)
  Definition form references ts := canonical (first_knowledge (references ++ ts)) branches references.
  Definition decide (ns : list need) (es : list (term * term)) : bool :=
    let f := form [] (terms_of ns es) in
    let ns := map (need_map f) ns in
    let es := map (fun e => (f (fst e), f (snd e))) es in
    let t := table_of (terms_of ns es ++ hints) in
    let hs := relevant t (map (need_map f) hypotheses) in
    let K := ready (with_roots (ready (learn (from_atoms t (polynomials t hints)) hs))) in
    forallb (meets K) ns &&& forallb (fun e => equal_terms K (fst e) (snd e)) es.

  Variable a : assignment.
  Hypotheses (B : along branches a) (H : Forall (met a) hypotheses).
  Lemma learn_right hs : Forall (met a) hs -> forall K, valid a K -> valid a (learn K hs).
  Proof.
    induction 1 as [|n hs M F IH]; simpl; intros K V; [exact V|]. apply IH. destruct V as [V1 V2]. split; [exact V1|].
    apply Forall_app. split; [exact V2|]. unfold learn_one.
    destruct (fraction_of K (about n)) as [[p q]|] eqn:E; [|constructor].
    assert (V : valid a K) by (split; assumption). apply (fraction_right a K V) in E as [N E]. apply met_sign in M. rewrite E in M.
    assert (G : has_sign (sign_needed n) (pv (values a K) (PEmul p q))) by (apply (proj1 (quotient_sign _ _ _ N)); exact M).
    destruct q as [| |z| | | | | | ]; try (constructor; [exact G|constructor]).
    destruct z as [|z|]; try (constructor; [exact G|constructor]). destruct z; try (constructor; [exact G|constructor]).
    constructor; [|constructor]. simpl in *. rewrite Rmult_1_r in G. exact G.
  Qed.
  Lemma from_atoms_right ts hs : valid a (from_atoms ts hs).
  Proof. split; [split; [apply circles_right|reflexivity]|constructor]. Qed.
  Lemma relevant_right t hs : Forall (met a) hs -> Forall (met a) (relevant t hs).
  Proof. intros F. apply Forall_forall. intros n N. apply filter_In in N as [N _]. rewrite Forall_forall in F. auto. Qed.
  Lemma ready_right K : valid a K -> valid a (ready K). Proof. auto. Qed.
  Lemma one_root_right K t : valid a K ->
    Forall (holds_at (values a K)) (fst (one_root K t)) /\ Forall (fun f => has_sign (fst f) (pv (values a K) (snd f))) (snd (one_root K t)).
  Proof.
    intros V. set (goal := fun r => Forall (holds_at (values a K)) (fst r) /\ Forall (fun f => has_sign (fst f) (pv (values a K) (snd f))) (snd r)).
    change (goal (one_root K t)). assert (none : goal ([], [])) by (split; constructor).
    destruct t; try exact none. unfold one_root. destruct (atom (table K) (Sqrt t)) as [x|] eqn:A; [|exact none].
    destruct x as [| |?|i| | | | | | |]; try exact none. destruct (fraction_of K t) as [[p q]|] eqn:F; [|exact none].
    destruct q as [| |z| | | | | | ]; try exact none. destruct z as [|z|]; try exact none. destruct z; try exact none.
    destruct (proves K NotBelow p) eqn:P; [|exact none]. destruct V as [V1 V2].
    pose proof (proves_right K (values a K) V1 V2 _ _ P) as S. simpl in S.
    pose proof (atom_value a (table K) (Sqrt t) _ A) as E. simpl in E.
    apply (fraction_right a K (conj V1 V2)) in F as [_ F]. simpl in F.
    assert (T : eval a t = pv (values a K) p) by (rewrite F; field).
    change (BinList.nth 0 i (values a K) = sqrt (eval a t)) in E.
    split; (constructor; [|constructor]).
    - unfold holds_at. cbn [fst snd PEeval]. change (N.to_nat 2) with 2%nat. rewrite E. simpl. rewrite Rmult_1_r, sqrt_sqrt; [exact T|]. rewrite T. exact S.
    - cbn [fst snd PEeval]. rewrite E. destruct (proves K Above p) eqn:P'; simpl.
      + apply sqrt_lt_R0. rewrite T. exact (proves_right K (values a K) V1 V2 _ _ P').
      + apply sqrt_pos.
  Qed.
  Lemma with_roots_right K : valid a K -> valid a (with_roots K).
  Proof.
    intros V. pose proof (one_root_right K) as O. destruct V as [[V1 V3] V2].
    split; [split; [|reflexivity]|]; simpl; apply Forall_app; (split; [assumption|]); apply Forall_flat_map, Forall_forall; intros r Hr;
      apply in_map_iff in Hr as (t & <- & _); apply (O t (conj (conj V1 V3) V2)).
  Qed.
  Lemma form_right references ts t : eval a (form references ts t) = eval a t.
  Proof. apply canonical_right; [|exact B]. apply ready_right, learn_right; [apply relevant_right; exact H|]. apply from_atoms_right. Qed.
  Lemma form_met references ts n : met a (need_map (form references ts) n) <-> met a n.
  Proof. destruct n; simpl; rewrite form_right; reflexivity. Qed.
  Theorem decide_right ns es : decide ns es = true -> Forall (met a) ns /\ Forall (fun e => eval a (fst e) = eval a (snd e)) es.
  Proof.
    unfold decide. set (ts := terms_of ns es). intros D. apply both_true in D as [D1 D2].
    rewrite forallb_forall in D1, D2.
    match type of D1 with forall x, _ -> meets ?K x = true => assert (V : valid a K) end.
    { apply ready_right, with_roots_right, ready_right, learn_right; [|apply from_atoms_right]. apply relevant_right, Forall_forall. intros n Hn.
      apply in_map_iff in Hn as (m & <- & Hm). apply form_met. rewrite Forall_forall in H. auto. }
    split; apply Forall_forall.
    - intros n Hn. apply (form_met [] ts). apply (meets_right a _ V). apply D1. apply in_map. exact Hn.
    - intros e He. rewrite <- (form_right [] ts (fst e)), <- (form_right [] ts (snd e)).
      apply (equal_terms_right a _ V). apply (D2 (form [] ts (fst e), form [] ts (snd e))). apply (in_map (fun e => (form [] ts (fst e), form [] ts (snd e)))). exact He.
  Qed.
End Decision.

(** ** Statements of documents *)
Fixpoint paired {A} (u v : list A) : option (list (A * A)) := match u, v with
  | [], [] => Some [] | x :: u, y :: v => do l <- paired u v; Some ((x, y) :: l) | _, _ => None end.
Fixpoint pairs (m n : matrix) : option (list (term * term)) := match m, n with
  | [], [] => Some []
  | r :: m, s :: n => do l <- paired r s; do k <- pairs m n; Some (flat_map (fun '(c, d) => [(fst c, fst d); (snd c, snd d)]) l ++ k)
  | _, _ => None end.
Lemma pairs_right a m : forall n l, pairs m n = Some l -> Forall (fun e => eval a (fst e) = eval a (snd e)) l ->
  map (map (cvalue a)) m = map (map (cvalue a)) n.
Proof.
  induction m as [|r m IH]; destruct n as [|s n]; simpl; intros l E F; try discriminate; [reflexivity|].
  destruct (paired r s) as [k|] eqn:P; [|discriminate]. destruct (pairs m n) as [k'|] eqn:Q; [|discriminate].
  injection E as <-. apply Forall_app in F as [F1 F2]. f_equal; [|eapply IH; eauto].
  clear - P F1. revert s k P F1. induction r as [|c r IH]; destruct s as [|d s]; simpl; intros k P F; try discriminate; [reflexivity|].
  destruct (paired r s) as [k'|] eqn:E; [|discriminate]. injection P as <-. simpl in F. inversion F as [|? ? E1 F']; subst. inversion F' as [|? ? E2 F'']; subst.
  f_equal; [|eapply IH; eauto]. unfold cvalue. simpl in *. congruence.
Qed.

Definition check_equal branches hypotheses hints x y : bool :=
  same_shape (entries x) (entries y) &&& match pairs (entries x) (entries y) with
  | Some l => decide branches hypotheses hints (needs x ++ needs y) l | None => false end.
Theorem equal_by_check branches hypotheses hints x y :
  check_equal branches hypotheses hints x y = true -> follows branches hypotheses (fun a => equal a x y).
Proof.
  unfold check_equal. intros C a B H. apply both_true in C as [S C]. destruct (pairs _ _) as [l|] eqn:P; [|discriminate].
  destruct (decide_right branches hypotheses hints a B H _ _ C) as [N E]. split; [exact S|]. split; [exact N|]. eapply pairs_right; eauto.
Qed.

Definition check_order n branches hypotheses hints x y : bool :=
  (is_scalar x && is_scalar y && is_real (single x) && is_real (single y)) &&&
  decide branches hypotheses hints (n (sub (fst (single y)) (fst (single x))) :: needs x ++ needs y) [].
Theorem below_by_check branches hypotheses hints x y :
  check_order Positive branches hypotheses hints x y = true -> follows branches hypotheses (fun a => below a x y).
Proof.
  intros C a B H. apply both_true in C as [S C]. destruct (decide_right branches hypotheses hints a B H _ _ C) as [N _].
  pose proof (Forall_inv N) as N1. pose proof (Forall_inv_tail N) as N2. simpl in N1. rewrite eval_sub in N1. repeat split; [exact S|exact N2|lra].
Qed.
Theorem not_above_by_check branches hypotheses hints x y :
  check_order NonNegative branches hypotheses hints x y = true -> follows branches hypotheses (fun a => not_above a x y).
Proof.
  intros C a B H. apply both_true in C as [S C]. destruct (decide_right branches hypotheses hints a B H _ _ C) as [N _].
  pose proof (Forall_inv N) as N1. pose proof (Forall_inv_tail N) as N2. simpl in N1. rewrite eval_sub in N1. repeat split; [exact S|exact N2|lra].
Qed.
Ltac by_rule hints := lazymatch goal with
  | |- follows ?b ?h (fun a => equal a ?x ?y) => apply (equal_by_check b h hints x y)
  | |- follows ?b ?h (fun a => below a ?x ?y) => apply (below_by_check b h hints x y)
  | |- follows ?b ?h (fun a => not_above a ?x ?y) => apply (not_above_by_check b h hints x y) end.
Ltac by_check := by_rule (@nil term); vm_cast_no_check (eq_refl true).
Ltac by_check_with hints := by_rule hints; vm_cast_no_check (eq_refl true).
(** Whether the checker accepts a statement, said at once: for looking, not for proving. *)
Ltac accepts := by_rule (@nil term); vm_compute; reflexivity.
Ltac accepts_with hints := by_rule hints; vm_compute; reflexivity.
