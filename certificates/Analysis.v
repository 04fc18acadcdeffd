(** What Calculus.v calls replacement, derivative and Taylor's coefficients is that of real analysis. *)
From Certificate Require Export Rewrite.
Definition is_derivative := derivable_pt_lim.
Local Arguments pow : simpl never. Local Arguments mul : simpl never. Local Arguments add : simpl never. Local Arguments sub : simpl never.
Local Arguments div : simpl never. Local Arguments opp : simpl never. Local Arguments root : simpl never.

(** ** A replacement has the value of the expression under the replaced assignment. *)
Theorem subst_right a b f :
  (forall u v, f u = Some v -> eval b u = eval a v) ->
  (forall p, f (Const p) = None -> constant b p = constant a p) ->
  (forall p k, f (Coord p k) = None -> coordinate b p k = coordinate a p k) ->
  function b = function a -> direction b = direction a ->
  forall t, eval a (subst f t) = eval b t.
Proof.
  intros S C Q F G. induction t; simpl.
  all: lazymatch goal with |- context [match ?x with _ => _ end] => destruct x eqn:E; [symmetry; exact (S _ _ E)|] end.
  all: rewrite ?eval_add, ?eval_sub, ?eval_mul, ?eval_div, ?eval_opp, ?eval_pow, ?eval_sine, ?eval_cosine, ?eval_root; simpl; rewrite ?F, ?G; try congruence.
  - symmetry. apply C. exact E.
  - symmetry. apply Q. exact E.
Qed.

(** ** Derivatives *)
(** The angle of a vector turns with the vector. *)
Definition turns (dir : R -> R -> R) (x y : R) := forall (u v : R -> R) z u' v', u z = x -> v z = y ->
  is_derivative u z u' -> is_derivative v z v' -> is_derivative (fun s => dir (u s) (v s)) z ((x * v' - y * u') / (x ^ 2 + y ^ 2)).
(** There is nothing that is divided by 0, and no root of 0. *)
Fixpoint regular (a : assignment) (t : term) : Prop := match t with
  | Num _ | Const _ | Coord _ _ => True
  | Add s t | Sub s t | Mul s t => regular a s /\ regular a t
  | Div s t => regular a s /\ regular a t /\ eval a t <> 0
  | Opp t | Pow t _ | Sin t | Cos t | App _ _ t => regular a t
  | Sqrt t => regular a t /\ 0 < eval a t
  | Ang x y => regular a x /\ regular a y /\ turns (direction a) (eval a x) (eval a y)
  end.
(** Each function of the document is followed by its derivative. *)
Definition smooth (a : assignment) := forall f k x, is_derivative (function a f k) x (function a f (S k) x).

Lemma derivative_ext f g x k k' : (forall z, f z = g z) -> k = k' -> is_derivative f x k -> is_derivative g x k'.
Proof. intros H -> L eps he. destruct (L eps he) as [d Hd]. exists d. intros. rewrite <- !H. auto. Qed.
Lemma derivative_pow f x k n : is_derivative f x k -> is_derivative (fun z => f z ^ n) x (INR n * f x ^ (pred n) * k).
Proof. intros H. exact (derivable_pt_lim_comp f (fun y => y ^ n) x k _ H (derivable_pt_lim_pow (f x) n)). Qed.

(** Along any motion of the assignment, [D] is the derivative. *)
Theorem D_right (motion : R -> assignment) (x : R) (f : term -> term) :
  (forall z, function (motion z) = function (motion x)) -> (forall z, direction (motion z) = direction (motion x)) ->
  smooth (motion x) ->
  (forall p, is_derivative (fun z => constant (motion z) p) x (eval (motion x) (f (Const p)))) ->
  (forall p k, is_derivative (fun z => coordinate (motion z) p k) x (eval (motion x) (f (Coord p k)))) ->
  forall t, regular (motion x) t -> is_derivative (fun z => eval (motion z) t) x (eval (motion x) (D f t)).
Proof.
  intros F G S C Q. induction t; simpl regular; intros W; simpl D.
  - exact (derivable_pt_lim_const (IZR z) x).
  - exact (C p).
  - exact (Q p k).
  - rewrite eval_add. destruct W. exact (derivable_pt_lim_plus _ _ _ _ _ (IHt1 H) (IHt2 H0)).
  - rewrite eval_sub. destruct W. exact (derivable_pt_lim_minus _ _ _ _ _ (IHt1 H) (IHt2 H0)).
  - rewrite eval_add, !eval_mul. destruct W. exact (derivable_pt_lim_mult _ _ _ _ _ (IHt1 H) (IHt2 H0)).
  - rewrite eval_sub, !eval_div, eval_mul, eval_pow. destruct W as (W1 & W2 & N).
    eapply derivative_ext; [reflexivity| |exact (derivable_pt_lim_div _ _ _ _ _ (IHt1 W1) (IHt2 W2) N)].
    unfold Rsqr. simpl. change (Pos.to_nat 2) with 2%nat. simpl. field. exact N.
  - rewrite eval_opp. exact (derivable_pt_lim_opp _ _ _ (IHt W)).
  - rewrite !eval_mul, eval_pow. eapply derivative_ext; [reflexivity| |exact (derivative_pow _ _ _ (N.to_nat n) (IHt W))].
    rewrite Nnat.N2Nat.inj_pred. simpl. rewrite INR_IZR_INZ, N_nat_Z. ring.
  - rewrite eval_mul, eval_cosine. exact (derivable_pt_lim_comp _ _ _ _ _ (IHt W) (derivable_pt_lim_sin _)).
  - rewrite eval_opp, eval_mul, eval_sine. eapply derivative_ext; [reflexivity| |exact (derivable_pt_lim_comp _ _ _ _ _ (IHt W) (derivable_pt_lim_cos _))]. ring.
  - rewrite eval_div, eval_mul, eval_root. destruct W as [W P].
    eapply derivative_ext; [reflexivity| |exact (derivable_pt_lim_comp _ _ _ _ _ (IHt W) (derivable_pt_lim_sqrt _ P))].
    simpl. unfold Rdiv. ring.
  - rewrite eval_mul. eapply derivative_ext with (f := fun z => function (motion x) f0 k (eval (motion z) t)); [| |exact (derivable_pt_lim_comp _ _ _ _ _ (IHt W) (S f0 k _))].
    + intros z. simpl. rewrite (F z). reflexivity.
    + simpl. ring.
  - rewrite eval_div, eval_sub, eval_add, !eval_mul, !eval_pow. destruct W as (W1 & W2 & T).
    eapply derivative_ext with (f := fun z => direction (motion x) (eval (motion z) t1) (eval (motion z) t2)); [| |exact (T _ _ x _ _ eq_refl eq_refl (IHt1 W1) (IHt2 W2))].
    + intros z. simpl. rewrite (G z). reflexivity.
    + simpl. change (Pos.to_nat 2) with 2%nat. reflexivity.
Qed.

(** ** Taylor's coefficients *)
Definition with_mark (a : assignment) (z : R) := Assignment (fun p => match p with xH => z | _ => constant a p end) (coordinate a) (function a) (direction a).
(** The terms of which Taylor's coefficients are made are the derivatives of the first by what is small, one after
    the other; the coefficient of order k is the k-th at 0, over k!. *)
Theorem taylor_right a n t : smooth a ->
  (forall k z u u', nth_error (derivatives by_mark n t) k = Some u -> nth_error (derivatives by_mark n t) (S k) = Some u' ->
    regular (with_mark a z) u -> is_derivative (fun z => eval (with_mark a z) u) z (eval (with_mark a z) u')) /\
  (forall k u, (k <= n)%nat -> nth_error (derivatives by_mark n t) k = Some u ->
    eval a (nth k (taylor n t) (Num 0)) = eval (with_mark a 0) u / INR (fact k)).
Proof.
  intros S. split.
  - intros k z u u' H H' W. assert (E : u' = D by_mark u).
    { revert t k H H'. induction n as [|n IH]; intros t k H H'; simpl in *.
      - destruct k; simpl in *; [discriminate|]. destruct k; discriminate.
      - destruct k; simpl in *; [|eapply IH; eauto]. injection H as <-. destruct n; simpl in H'; injection H' as <-; reflexivity. }
    subst u'. apply (D_right (with_mark a) z by_mark); try reflexivity; [exact S| | |exact W].
    + intros p. destruct p; simpl; [exact (derivable_pt_lim_const _ z)|exact (derivable_pt_lim_const _ z)|exact (derivable_pt_lim_id z)].
    + intros p k'. exact (derivable_pt_lim_const _ z).
  - intros k u L H. unfold taylor.
    assert (E : nth k (zip (fun k t => div (subst at_mark_0 t) (Num (factorial k))) (seq 0 (Datatypes.S n)) (derivatives by_mark n t)) (Num 0) = div (subst at_mark_0 u) (Num (factorial (0 + k)))).
    { clear S. generalize 0%nat as b. revert t k L H. induction n as [|n IH]; intros t k L H b.
      - destruct k; [|destruct k; discriminate]. simpl in *. injection H as <-. rewrite Nat.add_0_r. reflexivity.
      - destruct k; simpl in H.
        + injection H as <-. simpl. rewrite Nat.add_0_r. reflexivity.
        + etransitivity; [exact (IH (D by_mark t) k (le_S_n _ _ L) H (Datatypes.S b))|]. rewrite Nat.add_succ_r. reflexivity. }
    rewrite E, eval_div. simpl. unfold factorial. rewrite <- INR_IZR_INZ. f_equal.
    apply (subst_right a (with_mark a 0) at_mark_0); try reflexivity.
    + intros v w. destruct v; simpl; try discriminate. destruct p; try discriminate. intros M. injection M as <-. reflexivity.
    + intros p. destruct p; simpl; [reflexivity|reflexivity|discriminate].
Qed.

(** ** There are such angles: near the direction of an angle β, that of a vector is β and an arc tangent. *)
Definition near (beta x y : R) := beta + atan ((y * cos beta - x * sin beta) / (x * cos beta + y * sin beta)).
Lemma near_along beta w : 0 < w -> near beta (w * cos beta) (w * sin beta) = beta.
Proof.
  intros W. unfold near. replace (w * sin beta * cos beta - w * cos beta * sin beta) with 0 by ring.
  unfold Rdiv. rewrite Rmult_0_l, atan_0. ring.
Qed.
Lemma near_turns beta x y : 0 < x * cos beta + y * sin beta -> turns (near beta) x y.
Proof.
  intros P u v z u' v' U V Hu Hv. unfold near.
  assert (HN : is_derivative (fun s => v s * cos beta - u s * sin beta) z (v' * cos beta - u' * sin beta)).
  { apply (derivable_pt_lim_minus (fun s => v s * cos beta) (fun s => u s * sin beta)).
    - eapply derivative_ext; [| |exact (derivable_pt_lim_scal v (cos beta) z v' Hv)]; [intros; unfold mult_real_fct; ring|ring].
    - eapply derivative_ext; [| |exact (derivable_pt_lim_scal u (sin beta) z u' Hu)]; [intros; unfold mult_real_fct; ring|ring]. }
  assert (HD : is_derivative (fun s => u s * cos beta + v s * sin beta) z (u' * cos beta + v' * sin beta)).
  { apply (derivable_pt_lim_plus (fun s => u s * cos beta) (fun s => v s * sin beta)).
    - eapply derivative_ext; [| |exact (derivable_pt_lim_scal u (cos beta) z u' Hu)]; [intros; unfold mult_real_fct; ring|ring].
    - eapply derivative_ext; [| |exact (derivable_pt_lim_scal v (sin beta) z v' Hv)]; [intros; unfold mult_real_fct; ring|ring]. }
  assert (N : u z * cos beta + v z * sin beta <> 0) by (rewrite U, V; lra).
  pose proof (derivable_pt_lim_div _ _ _ _ _ HN HD N) as HQ.
  pose proof (derivable_pt_lim_comp _ atan z _ _ HQ (derivable_pt_lim_atan _)) as HA.
  eapply derivative_ext; [| |exact (derivable_pt_lim_plus (fun _ => beta) _ z _ _ (derivable_pt_lim_const beta z) HA)]; [reflexivity|].
  unfold comp, div_fct, Rsqr in *. rewrite U, V in *. pose proof (sin2_cos2 beta) as SC. unfold Rsqr in SC.
  assert (M : (x * cos beta + y * sin beta) ^ 2 + (y * cos beta - x * sin beta) ^ 2 = x ^ 2 + y ^ 2).
  { replace (x ^ 2 + y ^ 2) with ((x ^ 2 + y ^ 2) * (sin beta * sin beta + cos beta * cos beta)) by (rewrite SC; ring). ring. }
  assert (M0 : x ^ 2 + y ^ 2 <> 0) by (rewrite <- M; pose proof (pow2_ge_0 (y * cos beta - x * sin beta)); nra).
  rewrite <- M in M0 |- *. 
  replace (x * v' - y * u') with ((x * v' - y * u') * (sin beta * sin beta + cos beta * cos beta)) by (rewrite SC; ring).
  field. repeat split; try lra; try exact M0; intros Z; apply M0; rewrite <- Z; ring.
Qed.
