(** Signs of polynomials, from those that are known. A search, of which nothing is proved, proposes a product or a sum
    whose sign is plain; that it is equal to the polynomial, and has the sign, is checked. *)
From Certificate Require Export Normal.

(** Conjunction and disjunction that leave their second half alone where the first decides *)
Notation "a &&& b" := (if a then b else false) (at level 40, left associativity).
Notation "a ||| b" := (if a then true else b) (at level 50, left associativity).
Lemma both_true (a b : bool) : a &&& b = true -> a = true /\ b = true. Proof. destruct a; intuition discriminate. Qed.
Lemma one_true (a b : bool) : a ||| b = true -> a = true \/ b = true. Proof. destruct a; intuition discriminate. Qed.

(** ** The search: sparse polynomials, terms in falling order *)
Definition mono := list (positive * positive).
Definition sparse := list (Z * mono).
Fixpoint order (m n : mono) : comparison :=
  match m, n with
  | [], [] => Eq | [], _ => Lt | _, [] => Gt
  | (i, d) :: m, (j, e) :: n => match Pos.compare i j with Lt => Gt | Gt => Lt | Eq =>
      match Pos.compare d e with Eq => order m n | c => c end end
  end.
Fixpoint mtimes (m : mono) := fix go (n : mono) : mono :=
  match m, n with
  | [], _ => n | _, [] => m
  | (i, d) :: m', (j, e) :: n' => match Pos.compare i j with
      | Lt => (i, d) :: mtimes m' n | Gt => (j, e) :: go n' | Eq => (i, (d + e)%positive) :: mtimes m' n' end
  end.
Fixpoint mover (n m : mono) : option mono :=
  match n, m with
  | _, [] => Some n | [], _ => None
  | (i, d) :: n', (j, e) :: m' => match Pos.compare i j with
      | Lt => do q <- mover n' m; Some ((i, d) :: q) | Gt => None
      | Eq => match Pos.compare d e with Lt => None | Eq => mover n' m' | Gt => do q <- mover n' m'; Some ((i, (d - e)%positive) :: q) end end
  end.
Fixpoint splus (p : sparse) := fix go (q : sparse) : sparse :=
  match p, q with
  | [], _ => q | _, [] => p
  | (c, m) :: p', (d, n) :: q' => match order m n with
      | Gt => (c, m) :: splus p' q | Lt => (d, n) :: go q'
      | Eq => if Z.eqb (c + d) 0 then splus p' q' else ((c + d)%Z, m) :: splus p' q' end
  end.
Definition stimes (c : Z) (m : mono) (p : sparse) : sparse := map (fun '(k, n) => ((c * k)%Z, mtimes m n)) p.
(** [k p = q f]: the factor and the quotient *)
Fixpoint divide (fuel : nat) (p f q : sparse) (k : Z) : option (Z * sparse) :=
  match fuel, p, f with
  | _, [], _ => Some (k, q)
  | S fuel, (c, m) :: _, (d, n) :: _ => do r <- mover m n;
      let g := Z.gcd c d in let up := (Z.abs d / g)%Z in let e := (Z.sgn d * (c / g))%Z in
      divide fuel (splus (stimes up [] p) (stimes (- e) r f)) f (splus (stimes up [] q) [(e, r)]) (k * up)%Z
  | _, _, _ => None
  end.
Fixpoint monos (i : positive) (p : Pol Z) : sparse := match p with
  | Pc c => if Z.eqb c 0 then [] else [(c, [])]
  | Pinj j p => monos (i + j) p
  | PX p n q => splus (stimes 1 [(i, n)] (monos i p)) (monos (Pos.succ i) q) end.

(** ** What is proposed *)
Inductive sign := Above | NotBelow | Apart | Below | NotAbove.     (* > 0, ≥ 0, ≠ 0, < 0, ≤ 0 *)
Definition has_sign s (x : R) := match s with Above => 0 < x | NotBelow => 0 <= x | Apart => x <> 0 | Below => x < 0 | NotAbove => x <= 0 end.
Definition implies s s' := match s, s' with
  | Above, (Above | NotBelow | Apart) | NotBelow, NotBelow | Apart, Apart | Below, (Below | NotAbove | Apart) | NotAbove, NotAbove => true
  | _, _ => false end.
Inductive plan := Fact (i : nat) | Number (z : Z) | Product (p q : plan) | Sum (p q : plan) | Square (x : pe) | Power (p : plan) (n : N).
(** What is known: the atoms, the squares of some, signs of polynomials. The rules are what the relations are to the
    normaliser; divisors and factors only guide the search. *)
Definition rule_list := list (Z * Mon * Pol Z).
Record knowledge := Knowledge {
  table : list term; relations : list (pe * pe); rules : rule_list;
  facts : list (sign * pe); divisors : list pe; factors : list (sparse * plan) }.
Section Plans.
  Variable K : knowledge.
  Definition known_fact i := nth i (facts K) (Apart, PEc 1%Z).
  Fixpoint body (p : plan) : pe := match p with
    | Fact i => snd (known_fact i) | Number z => PEc z
    | Product p q => PEmul (body p) (body q) | Sum p q => PEadd (body p) (body q)
    | Square x => PEpow x 2 | Power p n => PEpow (body p) n end.
  Definition product_sign s s' := match s, s' with
    | Above, s | s, Above => Some s
    | Below, Below => Some Above | Below, NotBelow | NotBelow, Below => Some NotAbove
    | Below, NotAbove | NotAbove, Below => Some NotBelow | Below, Apart | Apart, Below => Some Apart
    | NotBelow, NotBelow | NotAbove, NotAbove => Some NotBelow | NotBelow, NotAbove | NotAbove, NotBelow => Some NotAbove
    | Apart, Apart => Some Apart | _, _ => None end.
  Definition sum_sign s s' := match s, s' with
    | Above, (Above | NotBelow) | NotBelow, Above => Some Above | NotBelow, NotBelow => Some NotBelow
    | Below, (Below | NotAbove) | NotAbove, Below => Some Below | NotAbove, NotAbove => Some NotAbove | _, _ => None end.
  Definition even_sign s := match s with NotBelow | NotAbove => NotBelow | _ => Above end.
  Fixpoint plan_sign (p : plan) : option sign := match p with
    | Fact i => Some (fst (known_fact i))
    | Number z => match z with Zpos _ => Some Above | Z0 => Some NotBelow | Zneg _ => Some Below end
    | Product p q => do s <- plan_sign p; do s' <- plan_sign q; product_sign s s'
    | Sum p q => do s <- plan_sign p; do s' <- plan_sign q; sum_sign s s'
    | Square _ => Some NotBelow
    | Power p n => do s <- plan_sign p; if N.even n then Some (even_sign s) else Some s end.

  Definition polynomial p := nsub rounds (rules K) p.
  Definition plain p := nsub rounds [] p.
  (** Which fact is the sign of an atom *)
  Fixpoint fact_of_atom (i : positive) (l : list (sign * pe)) (n : nat) : option plan := match l with
    | [] => None
    | (_, PEX _ j) :: l => if Pos.eqb i j then Some (Fact n) else fact_of_atom i l (S n)
    | _ :: l => fact_of_atom i l (S n) end.
  Fixpoint of_mono (m : mono) : option plan := match m with
    | [] => Some (Number 1)
    | (i, e) :: m => do r <- of_mono m;
        match fact_of_atom i (facts K) 0 with
        | Some f => Some (Product (Power f (Npos e)) r)
        | None => match e with xO h => Some (Product (Square (PEpow (PEX Z i) (Npos h))) r) | _ => None end end end.
  Fixpoint of_sum (p : sparse) : option plan := match p with
    | [] => Some (Number 0)
    | [(c, m)] => do r <- of_mono m; Some (Product (Number c) r)
    | (c, m) :: p => do r <- of_mono m; do s <- of_sum p; Some (Sum (Product (Number c) r) s) end.
  Definition opposite (p : sparse) := map (fun '(c, m) => ((- c)%Z, m)) p.
  (** What is negative in a sum is taken into a multiple of a known sum: − l n into n (r − l). *)
  Definition negative_term (p : sparse) := find (fun '(c, _) => Z.ltb c 0) p.
  Definition multiples (c : Z) (m : mono) (f : sparse) : list (Z * mono) :=
    flat_map (fun '(d, n) => if Z.ltb d 0 then match mover m n with Some q => if Z.eqb (c mod d) 0 then [((c / d)%Z, q)] else [] | None => [] end else []) f.
  Fixpoint of_facts (fuel : nat) (several : list (sparse * plan)) (p : sparse) : option plan :=
    match negative_term p, fuel with
    | None, _ => of_sum p
    | Some _, O => None
    | Some (c, m), S fuel =>
        (fix try l := match l with [] => None
          | (f, w) :: l =>
              match (fix each_multiple ms := match ms with [] => None
                | (k, q) :: ms => match of_mono q, of_facts fuel several (splus p (stimes (- k) q f)) with
                    | Some v, Some r => Some (Sum (Product (Product (Number k) v) w) r) | _, _ => each_multiple ms end end) (multiples c m f)
              with Some r => Some r | None => try l end end) several
    end.
  Definition several := flat_map (fun '(i, (s, f)) => match s with Apart => [] | _ =>
      let f := monos 1 (polynomial f) in if Nat.leb (length f) 1 then [] else [(f, Fact i)] end)
    (combine (seq 0 (length (facts K))) (facts K)).
  Definition of_positive (p : sparse) : option plan :=
    match of_facts (if Nat.leb (length p) 12 then 3 else 0) several p with Some w => Some w | None => None end.
  Definition of_rest (p : sparse) : option plan :=
    match of_positive p with Some w => Some w | None => do w <- of_positive (opposite p); Some (Product (Number (-1)) w) end.
  Definition of_divisor (p : pe) : list (sparse * plan) :=
    let m := monos 1 (polynomial p) in match of_rest m with Some w => [(m, w)]
      | None => [(monos 1 (polynomial (PEmul p p)), Square p)] end.
  Definition find_factors : list (sparse * plan) :=
    filter (fun '(f, _) => negb (Nat.eqb (length f) 0) && negb (Nat.eqb (length (snd (hd (0%Z, []) f))) 0))
      (map (fun '(i, (_, f)) => (monos 1 (polynomial f), Fact i)) (combine (seq 0 (length (facts K))) (facts K))
       ++ flat_map of_divisor (divisors K)).
  Fixpoint take_out (fuel : nat) (k : Z) (p f : sparse) (n : N) : Z * sparse * N :=
    match fuel with O => (k, p, n) | S fuel => match divide 400 p f [] 1 with
      | Some (k', q) => take_out fuel (k * k') q f (N.succ n)
      | None => (k, p, n) end end.
  Fixpoint taken (fs : list (sparse * plan)) (k : Z) (p : sparse) : Z * sparse * list plan :=
    match fs with [] => (k, p, []) | (f, w) :: fs =>
      let '(k, q, n) := take_out 12 k p f 0 in let '(k, q, l) := taken fs k q in
      (k, q, match n with N0 => l | 1%N => w :: l | _ => Power w n :: l end) end.
  Definition propose (p : sparse) : option (Z * plan) :=
    match p with [] => Some (1%Z, Number 0) | _ =>
    let '(k, q, l) := taken (factors K) 1 p in
    do w <- of_rest q; Some (k, fold_right Product w l) end.
  (** A plan that follows the structure of a polynomial: equal factors of a product are a square. *)
  Fixpoint split_product (p : pe) : Z * list pe := match p with
    | PEmul a b => let '(c, l) := split_product a in let '(d, m) := split_product b in ((c * d)%Z, l ++ m)
    | PEopp a => let '(c, l) := split_product a in ((- c)%Z, l)
    | PEc z => (z, [])
    | _ => (1%Z, [p]) end.
  Definition alike p q := peq (plain p) (plain q).
  Fixpoint take (p : pe) (l : list pe) : option (list pe) := match l with
    | [] => None | q :: l => if alike p q then Some l else do r <- take p l; Some (q :: r) end.
  Fixpoint couples (fuel : nat) (l : list pe) : list pe * list pe := match fuel, l with
    | S fuel, p :: l => match take p l with
        | Some r => let '(two, one) := couples fuel r in (p :: two, one)
        | None => let '(two, one) := couples fuel l in (two, p :: one) end
    | _, _ => ([], l) end.
  Definition apart_fact (p : pe) := (fix go n l := match l with [] => None
    | (_, f) :: l => if peq (polynomial p) (polynomial f) then Some (Fact n) else go (S n) l end) O (facts K).
  Definition square p := match apart_fact p with Some w => Power w 2 | None => Square p end.
  Definition at_once p := match propose (monos 1 (polynomial p)) with Some (1%Z, w) => Some w | _ => None end.
  Fixpoint structural (fuel : nat) (p : pe) : option plan :=
    match fuel with O => None | S fuel =>
    match at_once p with Some w => Some w | None =>
    match p with
    | PEadd a b => do v <- structural fuel a; do w <- structural fuel b; Some (Sum v w)
    | PEsub a b => do v <- structural fuel a; do w <- structural fuel (PEopp b); Some (Sum v w)
    | PEpow a n => if N.even n then Some (square (PEpow a (N.div2 n))) else do w <- structural fuel a; Some (Power w n)
    | PEmul _ _ | PEopp _ =>
        let '(c, l) := split_product p in let '(two, one) := couples (length l) l in
        if Z.leb (Z.of_nat (length one) + Z.of_nat (length two)) 0 then Some (Number c) else
        (fix all l := match l with [] => Some (fold_right (fun q w => Product (square q) w) (Number c) two)
          | q :: l => do v <- structural fuel q; do w <- all l; Some (Product v w) end) one
    | _ => None end end end.
  Definition accepts s p (proposal : option (Z * plan)) := match proposal with
    | Some (k, w) => match plan_sign w with
        | Some s' => implies s' s &&& Z.ltb 0 k &&& peq (polynomial (PEmul (PEc k) p)) (polynomial (body w))
        | None => false end
    | None => false end.
  Definition proves s p := accepts s p (propose (monos 1 (polynomial p))) ||| accepts s p (propose (monos 1 (plain p)))
    ||| accepts s p (option_map (pair 1%Z) (structural 12 p)).
End Plans.

Section Right.
  Variables (K : knowledge) (l : list R).
  Hypothesis Hrelations : Forall (holds_at l) (relations K) /\ rules K = mlist (relations K).
  Hypothesis Hfacts : Forall (fun f => has_sign (fst f) (pv l (snd f))) (facts K).
  Lemma polynomial_right p q : peq (polynomial K p) (polynomial K q) = true -> pv l p = pv l q.
  Proof. destruct Hrelations as [H E]. unfold polynomial. rewrite E. apply polynomials_equal, rels_Forall, H. Qed.
  Lemma fact_right i : has_sign (fst (known_fact K i)) (pv l (snd (known_fact K i))).
  Proof.
    unfold known_fact. destruct (nth_in_or_default i (facts K) (Apart, PEc 1%Z)) as [H| ->].
    - rewrite Forall_forall in Hfacts. apply (Hfacts _ H).
    - simpl. lra.
  Qed.
  Lemma product_right s s' s'' x y : product_sign s s' = Some s'' -> has_sign s x -> has_sign s' y -> has_sign s'' (x * y).
  Proof.
    destruct s, s'; simpl; intros E; try discriminate; injection E as <-; simpl; intros Hx Hy;
      try (apply Rmult_integral_contrapositive_currified; lra); nra.
  Qed.
  Lemma sum_right s s' s'' x y : sum_sign s s' = Some s'' -> has_sign s x -> has_sign s' y -> has_sign s'' (x + y).
  Proof. destruct s, s'; simpl; intros E; try discriminate; injection E as <-; simpl; lra. Qed.
  Lemma even_right s x n : has_sign s x -> N.even n = true -> has_sign (even_sign s) (x ^ N.to_nat n).
  Proof.
    intros H E. apply N.even_spec in E. destruct E as [m ->].
    rewrite Nnat.N2Nat.inj_mul. change (N.to_nat 2) with 2%nat. rewrite pow_mult.
    assert (P : x <> 0 -> 0 < (x ^ 2) ^ N.to_nat m). { intros. apply pow_lt. simpl. rewrite Rmult_1_r. apply Rsqr_pos_lt. assumption. }
    assert (Q : 0 <= (x ^ 2) ^ N.to_nat m). { apply pow_le. simpl. rewrite Rmult_1_r. apply Rle_0_sqr. }
    destruct s; simpl in *; try exact Q; apply P; lra.
  Qed.
  Lemma odd_right s x n : has_sign s x -> N.even n = false -> has_sign s (x ^ N.to_nat n).
  Proof.
    intros H E. destruct s; simpl in *; [apply pow_lt|apply pow_le|apply pow_nonzero| |]; try assumption.
    all: rewrite <- N.negb_odd in E; apply (f_equal negb) in E; rewrite negb_involutive in E; simpl in E; apply N.odd_spec in E as [m ->].
    all: rewrite Nnat.N2Nat.inj_add, Nnat.N2Nat.inj_mul, pow_add, pow_mult; change (N.to_nat 2) with 2%nat; change (N.to_nat 1) with 1%nat; rewrite pow_1.
    all: assert (Q : 0 <= (x ^ 2) ^ N.to_nat m) by (apply pow_le; simpl; rewrite Rmult_1_r; apply Rle_0_sqr).
    - assert (P : 0 < (x ^ 2) ^ N.to_nat m) by (apply pow_lt; simpl; nra). nra.
    - nra.
  Qed.
  Lemma plan_right p : forall s, plan_sign K p = Some s -> has_sign s (pv l (body K p)).
  Proof.
    induction p; simpl; intros s H.
    - injection H as <-. apply fact_right.
    - destruct z; injection H as <-; simpl; [lra|apply IZR_lt; reflexivity|apply IZR_lt; reflexivity].
    - split_options. eapply product_right; eauto.
    - split_options. eapply sum_right; eauto.
    - injection H as <-. simpl. change (Pos.to_nat 2) with 2%nat. simpl. rewrite Rmult_1_r. apply Rle_0_sqr.
    - split_options. specialize (IHp _ eq_refl). destruct (N.even n) eqn:E; injection H as <-.
      + apply even_right; assumption.
      + apply odd_right; assumption.
  Qed.
  Lemma proves_right s p : proves K s p = true -> has_sign s (pv l p).
  Proof.
    assert (A : forall o, accepts K s p o = true -> has_sign s (pv l p)).
    { intros [[k w]|]; [|discriminate]. simpl. destruct (plan_sign K w) as [s'|] eqn:E; [|discriminate].
      intros H. apply both_true in H as [H H3]. apply both_true in H as [H1 H2]. apply Z.ltb_lt, IZR_lt in H2.
      apply polynomial_right in H3. apply plan_right in E. rewrite <- H3 in E. simpl in E.
      destruct s', s; try discriminate H1; simpl in *; try nra; intros ->; lra. }
    intros H. apply one_true in H as [H|H]; [apply one_true in H as [H|H]|]; eapply A; exact H.
  Qed.

  Fixpoint none_zero (seen : list (Pol Z)) (cs : list pe) : bool := match cs with
    | [] => true
    | c :: cs => let p := polynomial K c in
        if existsb (peq p) seen then none_zero seen cs else if proves K Apart c then none_zero (p :: seen) cs else false end.
  Lemma none_zero_right cs : forall seen, none_zero seen cs = true ->
    (forall p, In p seen -> exists c, p = polynomial K c /\ pv l c <> 0) -> Forall (fun c => pv l c <> 0) cs.
  Proof.
    induction cs as [|c cs IH]; simpl; intros seen H S; constructor.
    - destruct (existsb _ seen) eqn:E.
      + apply existsb_exists in E as (p & Hp & E). destruct (S p Hp) as (c' & -> & N). rewrite (polynomial_right c c' E). exact N.
      + destruct (proves K Apart c) eqn:P; [|discriminate]. apply (proves_right _ _ P).
    - destruct (existsb _ seen); [eapply IH; eauto|]. destruct (proves K Apart c) eqn:P; [|discriminate].
      eapply IH; [exact H|]. intros p [<-|Hp]; [|auto]. exists c. split; [reflexivity|]. apply (proves_right _ _ P).
  Qed.
End Right.

(** ** Terms *)
Definition fraction_of K t : option (pe * pe) :=
  do x <- flat (table K) t; let f := fnorm x in
  if none_zero K [] (condition f) then Some (num f, denum f) else None.
Definition equal_terms K s t : bool :=
  match flat (table K) s, flat (table K) t with
  | Some x, Some y => let f := fnorm x in let g := fnorm y in
      peq (polynomial K (PEmul (num f) (denum g))) (polynomial K (PEmul (num g) (denum f))) &&& none_zero K [] (condition f ++ condition g)
  | _, _ => false end.
Definition sign_needed n := match n with NonZero _ => Apart | Positive _ => Above | NonNegative _ => NotBelow end.
Definition about n := match n with NonZero t | Positive t | NonNegative t => t end.
Definition meets K n : bool := match fraction_of K (about n) with
  | Some (p, q) => proves K (sign_needed n) (PEmul p q) | None => false end.

Section Terms.
  Variables (a : assignment) (K : knowledge).
  Definition values := map (eval a) (table K).
  Definition valid := (Forall (holds_at values) (relations K) /\ rules K = mlist (relations K)) /\ Forall (fun f => has_sign (fst f) (pv values (snd f))) (facts K).
  Hypothesis V : valid.
  Lemma conditions_right cs : none_zero K [] cs = true -> Forall (fun c => pv values c <> 0) cs.
  Proof. destruct V. intros H1. eapply none_zero_right; eauto. intros p []. Qed.
  Lemma fraction_right t p q : fraction_of K t = Some (p, q) -> pv values q <> 0 /\ eval a t = pv values p / pv values q.
  Proof.
    unfold fraction_of. destruct (flat (table K) t) as [x|] eqn:E; [|discriminate].
    destruct (none_zero K [] (condition (fnorm x))) eqn:C; [|discriminate]. intros H. injection H as <- <-.
    apply conditions_right in C. rewrite <- (flat_value a (table K) t x E). apply fraction_value. exact C.
  Qed.
  Lemma equal_terms_right s t : equal_terms K s t = true -> eval a s = eval a t.
  Proof.
    unfold equal_terms. destruct (flat (table K) s) as [x|] eqn:E; [|discriminate]. destruct (flat (table K) t) as [y|] eqn:F; [|discriminate].
    intros H. apply both_true in H as [H C]. apply conditions_right in C. destruct V as [V1 V2].
    rewrite <- (flat_value a (table K) s x E), <- (flat_value a (table K) t y F).
    destruct V1 as [V1 E1]. unfold polynomial in H. rewrite E1 in H. eapply fractions_equal; [apply rels_Forall; exact V1 | exact C | exact H].
  Qed.
  Lemma quotient_sign s p q : q <> 0 -> (has_sign s (p / q) <-> has_sign s (p * q)).
  Proof.
    intros N. assert (E1 : p * q = p / q * (q * q)) by (field; exact N). assert (E2 : p / q = p * q * / (q * q)) by (field; exact N).
    assert (S : 0 < q * q) by (apply Rsqr_pos_lt; exact N). pose proof (Rinv_0_lt_compat _ S) as S'.
    destruct s; simpl; split; intros H.
    all: try (rewrite E1; try (apply Rmult_integral_contrapositive_currified; lra); nra).
    all: rewrite E2; try (apply Rmult_integral_contrapositive_currified; lra); nra.
  Qed.
  Lemma met_sign n : met a n <-> has_sign (sign_needed n) (eval a (about n)). Proof. destruct n; reflexivity. Qed.
  Lemma meets_right n : meets K n = true -> met a n.
  Proof.
    unfold meets. destruct (fraction_of K (about n)) as [[p q]|] eqn:E; [|discriminate]. intros H.
    apply fraction_right in E as [N E]. destruct V as [V1 V2]. apply met_sign. rewrite E. apply quotient_sign; [exact N|].
    apply (proves_right K values V1 V2 _ _ H).
  Qed.
End Terms.
