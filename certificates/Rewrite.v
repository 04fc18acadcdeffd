(** Arguments of functions, roots and angles of vectors get one form, so that equal ones are one atom. *)
From Certificate Require Export Sign.

(** ** What leaves out 0 and 1 has the value that it should have *)
Lemma is0_right a t : is0 t = true -> eval a t = 0.
Proof. destruct t as [z| | | | | | | | | | | | |]; try discriminate. destruct z; try discriminate. reflexivity. Qed.
Lemma is1_right a t : is1 t = true -> eval a t = 1.
Proof. destruct t as [z| | | | | | | | | | | | |]; try discriminate. destruct z as [|p|]; try discriminate. destruct p; try discriminate. reflexivity. Qed.
Ltac by_cases a := repeat match goal with
  | |- context [is0 ?t] => destruct (is0 t) eqn:?; try rewrite (is0_right a t) by assumption
  | |- context [is1 ?t] => destruct (is1 t) eqn:?; try rewrite (is1_right a t) by assumption end; simpl.
Lemma eval_add a s t : eval a (add s t) = eval a s + eval a t. Proof. unfold add. by_cases a; ring. Qed.
Lemma eval_opp a t : eval a (opp t) = - eval a t.
Proof. unfold opp. destruct t; simpl; try reflexivity; try ring. apply opp_IZR. Qed.
Lemma eval_sub a s t : eval a (sub s t) = eval a s - eval a t. Proof. unfold sub. by_cases a; rewrite ?eval_opp; ring. Qed.
Lemma eval_mul a s t : eval a (mul s t) = eval a s * eval a t. Proof. unfold mul. by_cases a; ring. Qed.
Lemma eval_div a s t : eval a (div s t) = eval a s / eval a t.
Proof. unfold div. by_cases a; unfold Rdiv; rewrite ?Rinv_1; ring. Qed.
Lemma eval_pow a t n : eval a (pow t n) = eval a t ^ N.to_nat n.
Proof.
  assert (G : forall p, eval a (if is0 t then Num 0 else if is1 t then t else Pow t (N.pos p)) = eval a t ^ Pos.to_nat p).
  { intros p. destruct (is0 t) eqn:E0; [|destruct (is1 t) eqn:E1; [|reflexivity]].
    - rewrite (is0_right a t E0), pow_ne_zero; [reflexivity|]. pose proof (Pos2Nat.is_pos p). lia.
    - rewrite (is1_right a t E1), pow1. reflexivity. }
  destruct n as [|p]; [reflexivity|]. destruct p; [apply G|apply G|]. simpl. ring.
Qed.
Lemma eval_sine a t : eval a (sine t) = sin (eval a t). Proof. unfold sine. by_cases a; rewrite ?sin_0; reflexivity. Qed.
Lemma eval_cosine a t : eval a (cosine t) = cos (eval a t). Proof. unfold cosine. by_cases a; rewrite ?cos_0; reflexivity. Qed.
Lemma eval_root a t : eval a (root t) = sqrt (eval a t). Proof. unfold root. by_cases a; rewrite ?sqrt_0, ?sqrt_1; reflexivity. Qed.

Section Canonical.
  Variables (K : knowledge) (branches references : list term).
  Definition atom_of (i : positive) := BinList.nth (Num 0) i (table K).
  Definition of_sparse (p : sparse) : term :=
    fold_right (fun '(c, m) t => add (mul (Num c) (fold_right (fun '(i, e) t => mul (pow (atom_of i) (Npos e)) t) (Num 1) m)) t) (Num 0) p.
  Definition argument x := match find (equal_terms K x) references with Some r => r | None =>
    match fraction_of K x with
    | Some (p, PEc 1%Z) => let y := of_sparse (monos 1 (polynomial K p)) in if equal_terms K x y then y else x
    | _ => x end end.
  Definition half (e : positive) := match e with xO h => Some h | _ => None end.
  Fixpoint mono_root (m : mono) : option term := match m with
    | [] => Some (Num 1) | (i, e) :: m => do h <- half e; do r <- mono_root m; Some (mul (pow (atom_of i) (Npos h)) r) end.
  Definition square_root (p : sparse) : option term := match p with
    | [(c, m)] => let s := Z.sqrt c in if Z.eqb (s * s) c then do r <- mono_root m; Some (mul (Num s) r) else None
    | _ => None end.
  Definition root_of x :=
    match fraction_of K x with None => Sqrt x | Some (p, q) =>
      let n := monos 1 (polynomial K (PEmul p q)) in
      let m := of_sparse n in
      let d := of_sparse (monos 1 (polynomial K q)) in
      if meets K (Positive d) &&& equal_terms K x (Div m (Mul d d)) then
        let r := match square_root n with
          | Some s => if meets K (NonNegative s) &&& equal_terms K m (Mul s s) then s else Sqrt m
          | None => Sqrt m end in
        div r d
      else Sqrt x end.
  Definition is_along u v b :=
    let w := Add (Mul u (Cos b)) (Mul v (Sin b)) in
    meets K (Positive w) &&& equal_terms K u (Mul w (Cos b)) &&& equal_terms K v (Mul w (Sin b)).
  Definition angle_of u v := match find (is_along u v) branches with Some b => b | None => Ang u v end.
  Fixpoint canonical (t : term) : term := match t with
    | Num _ | Const _ | Coord _ _ => t
    | Add s t => add (canonical s) (canonical t)
    | Sub s t => sub (canonical s) (canonical t)
    | Mul s t => mul (canonical s) (canonical t)
    | Div s t => div (canonical s) (canonical t)
    | Opp t => opp (canonical t)
    | Pow t n => pow (canonical t) n
    | Sin t => sine (canonical t)
    | Cos t => cosine (canonical t)
    | Sqrt t => root_of (canonical t)
    | App f k t => App f k (argument (canonical t))
    | Ang x y => angle_of (canonical x) (canonical y)
    end.

  Variable a : assignment.
  Hypotheses (V : valid a K) (B : along branches a).
  Lemma argument_right x : eval a (argument x) = eval a x.
  Proof.
    unfold argument. destruct (find (equal_terms K x) references) as [r|] eqn:F.
    { apply find_some in F as [_ F]. symmetry. apply (equal_terms_right a K V). exact F. }
    destruct (fraction_of K x) as [[p q]|]; auto. destruct q as [| |z| | | | | | ]; auto. destruct z as [|z|]; auto. destruct z; auto.
    destruct (equal_terms K x _) eqn:E; auto. symmetry. apply (equal_terms_right a K V). exact E.
  Qed.
  Lemma root_of_right x : eval a (root_of x) = sqrt (eval a x).
  Proof.
    unfold root_of. destruct (fraction_of K x) as [[p q]|]; [|reflexivity].
    set (m := of_sparse (monos 1 (polynomial K (PEmul p q)))). set (d := of_sparse _).
    destruct (meets K (Positive d)) eqn:P; [|reflexivity]. destruct (equal_terms K x _) eqn:E; [|reflexivity].
    apply (meets_right a K V) in P. apply (equal_terms_right a K V) in E. simpl in P, E. cbv iota.
    assert (S : forall r, eval a r = sqrt (eval a m) -> eval a (div r d) = sqrt (eval a x)).
    { intros r Hr. rewrite eval_div, Hr, E, sqrt_div_alt by (apply Rmult_lt_0_compat; exact P). rewrite sqrt_square by lra. reflexivity. }
    apply S. destruct (square_root _) as [s|]; [|reflexivity].
    destruct (meets K (NonNegative s)) eqn:N; [|reflexivity]. destruct (equal_terms K m (Mul s s)) eqn:F; [|reflexivity].
    apply (meets_right a K V) in N. apply (equal_terms_right a K V) in F. simpl in N, F. cbv iota. rewrite F, sqrt_square by exact N. reflexivity.
  Qed.
  Lemma angle_of_right u v : eval a (angle_of u v) = direction a (eval a u) (eval a v).
  Proof.
    unfold angle_of. destruct (find (is_along u v) branches) as [b|] eqn:F; [|reflexivity].
    apply find_some in F as [I F]. unfold is_along in F. apply both_true in F as [F F3]. apply both_true in F as [F1 F2].
    apply (meets_right a K V) in F1. apply (equal_terms_right a K V) in F2. apply (equal_terms_right a K V) in F3.
    unfold along in B. rewrite Forall_forall in B. specialize (B b I _ F1).
    change (eval a u = eval a (Add (Mul u (Cos b)) (Mul v (Sin b))) * cos (eval a b)) in F2.
    change (eval a v = eval a (Add (Mul u (Cos b)) (Mul v (Sin b))) * sin (eval a b)) in F3.
    rewrite F3, F2 at 1. symmetry. exact B.
  Qed.
  Lemma canonical_right t : eval a (canonical t) = eval a t.
  Proof.
    induction t; simpl; rewrite ?eval_add, ?eval_sub, ?eval_mul, ?eval_div, ?eval_opp, ?eval_pow, ?eval_sine, ?eval_cosine, ?root_of_right, ?angle_of_right; simpl; rewrite ?argument_right; congruence.
  Qed.
End Canonical.
