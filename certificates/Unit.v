(** Units, as what they are for real numbers: how a value changes when one measures in other units.

    A length is 1000 times as many millimetres as metres, an area 1000² times as many square millimetres. Of two values
    that change differently the sum depends on what one measures in: adding or comparing them has no meaning. *)
From Certificate Require Export Refute.
Require Import Lra.
Local Open Scope R_scope.

(** The exponents of kg, m, s, A and K, all of them doubled: the root of a length has one, too. *)
Definition dimension := list Z.
Definition pure : dimension := [0; 0; 0; 0; 0]%Z.

(** By what a value is multiplied that has a unit, where the numbers of kg, m, … are multiplied by the scales. *)
Fixpoint factor (scales : list R) (u : dimension) : R :=
  match scales, u with k :: scales, n :: u => Rpower k (IZR n / 2) * factor scales u | _, _ => 1 end.

(** The units of quantities, as they are declared: whole exponents. *)
Definition units := list (expr * list Z).
Definition leaf (x : expr) (t : term) : bool := existsb (fun c => if term_dec (fst c) t then true else if term_dec (snd c) t then true else false) (concat (entries x)).
Definition declared_unit (us : units) (t : term) : dimension :=
  match find (fun e => leaf (fst e) t) us with Some (_, u) => map (Z.mul 2) u | None => pure end.
Fixpoint per_second (k : nat) (u : dimension) : dimension := match k, u with S k, [a; b; c; d; e] => per_second k [a; b; (c - 2)%Z; d; e] | _, _ => u end.
Definition unit_of_function (us : units) f : dimension :=
  match find (fun e => match single (fst e) with (App g _ _, _) => Pos.eqb f g | _ => false end) us with Some (_, u) => map (Z.mul 2) u | None => pure end.

(** The same state of affairs, measured in other units. *)
Definition remeasured us scales (a : assignment) : assignment := Assignment
  (fun p => factor scales (declared_unit us (Const p)) * constant a p)
  (fun p k => factor scales (per_second k (declared_unit us (Coord p 0))) * coordinate a p k)
  (fun f k x => factor scales (unit_of_function us f) * function a f k x)
  (direction a).

(** The angle of a vector does not depend on what its length is measured in. *)
Definition turns_only (a : assignment) := forall x y w, 0 < w -> direction a (w * x) (w * y) = direction a x y.

Definition has_unit us (x : expr) (u : dimension) :=
  is_scalar x = true /\ is_real (single x) = true /\
  forall scales a, Forall (Rlt 0) scales -> turns_only a ->
    eval (remeasured us scales a) (fst (single x)) = factor scales u * eval a (fst (single x)).
Definition differ_in_unit us x y := exists u v, length u = length v /\ u <> v /\ has_unit us x u /\ has_unit us y v.

(** ** How factors multiply *)
Fixpoint sum (u v : dimension) : dimension := match u, v with [], _ => v | _, [] => u | m :: u, n :: v => (m + n)%Z :: sum u v end.
Lemma factor_sum ks : forall u v, factor ks (sum u v) = factor ks u * factor ks v.
Proof.
  induction ks as [|k ks IH]; destruct u as [|m u], v as [|n v]; simpl; try lra.
  rewrite IH, plus_IZR. replace ((IZR m + IZR n) / 2) with (IZR m / 2 + IZR n / 2) by field. rewrite Rpower_plus. ring.
Qed.
Lemma factor_positive ks : forall u, 0 < factor ks u.
Proof. induction ks as [|k ks IH]; destruct u as [|n u]; simpl; try lra. apply Rmult_lt_0_compat; [apply exp_pos|apply IH]. Qed.
Lemma factor_pure ks : Forall (Rlt 0) ks -> forall n, factor ks (repeat 0%Z n) = 1.
Proof.
  induction 1 as [|k ks P F IH]; destruct n; simpl; try reflexivity. rewrite IH. replace (0 / 2) with 0 by field. rewrite Rpower_O by exact P. ring.
Qed.
Fixpoint times (n : nat) (u : dimension) : dimension := match n with O => pure | S n => sum u (times n u) end.
Lemma factor_times ks : Forall (Rlt 0) ks -> forall n u, factor ks (times n u) = factor ks u ^ n.
Proof. intros P. induction n as [|n IH]; intros u; simpl; [exact (factor_pure ks P 5)|]. rewrite factor_sum, IH. reflexivity. Qed.

Definition same (u v : dimension) : bool := if list_eq_dec Z.eq_dec u v then true else false.
Lemma same_right u v : same u v = true -> u = v. Proof. unfold same. destruct (list_eq_dec Z.eq_dec u v); congruence. Qed.

(** ** The unit of a term, if it has one; 0 has every unit *)
Inductive found := Every | One (u : dimension).
Definition common (f g : option found) : option found := match f, g with
  | Some Every, Some h => Some h | Some h, Some Every => Some h
  | Some (One u), Some (One v) => if same u v then Some (One u) else None | _, _ => None end.
Definition without_unit (f : option found) := match f with Some Every => true | Some (One u) => same u pure | None => false end.
Definition halved (u : dimension) : option dimension := let h := map (fun n => (n / 2)%Z) u in if same (sum h h) u then Some h else None.
Definition less (u v : dimension) : option dimension := let w := sum u (map Z.opp v) in if same (sum w v) u then Some w else None.
Fixpoint unit_of us (t : term) : option found := match t with
  | Num z => Some (if Z.eqb z 0 then Every else One pure)
  | Const p => Some (One (declared_unit us (Const p)))
  | Coord p k => Some (One (per_second k (declared_unit us (Coord p 0))))
  | Add s t | Sub s t => common (unit_of us s) (unit_of us t)
  | Mul s t => match unit_of us s, unit_of us t with
      | Some (One u), Some (One v) => Some (One (sum u v)) | Some _, Some _ => Some Every | _, _ => None end
  | Div s t => match unit_of us s, unit_of us t with
      | Some (One u), Some (One v) => option_map One (less u v) | Some Every, Some (One _) => Some Every | _, _ => None end
  | Opp t => unit_of us t
  | Pow t n => match unit_of us t with Some (One u) => Some (One (times (N.to_nat n) u)) | _ => None end
  | Sin t | Cos t => if without_unit (unit_of us t) then Some (One pure) else None
  | Sqrt t => match unit_of us t with Some (One u) => option_map One (halved u) | _ => None end
  | App f k t => if without_unit (unit_of us t) then Some (One (unit_of_function us f)) else None
  | Ang x y => match common (unit_of us x) (unit_of us y) with Some (One _) => Some (One pure) | _ => None end
  end.

Section Measured.
  Variables (us : units) (ks : list R) (a : assignment).
  Hypotheses (P : Forall (Rlt 0) ks) (T : turns_only a).
  Let b := remeasured us ks a.
  Definition fits_unit (t : term) (f : found) : Prop :=
    match f with Every => eval a t = 0 /\ eval b t = 0 | One u => eval b t = factor ks u * eval a t end.
  Let pure_factor : factor ks pure = 1 := factor_pure ks P 5.

  Lemma every_fits t f : fits_unit t Every -> fits_unit t f.
  Proof. destruct f as [|u]; [auto|]. intros [E F]. simpl. rewrite E, F. ring. Qed.
  Lemma common_right s t f g h : fits_unit s f -> fits_unit t g -> common (Some f) (Some g) = Some h -> fits_unit s h /\ fits_unit t h.
  Proof.
    intros Hs Ht E. destruct f as [|u]; simpl in E.
    - injection E as <-. split; [apply every_fits|]; assumption.
    - destruct g as [|v]; [injection E as <-; split; [|apply every_fits]; assumption|].
      destruct (same u v) eqn:S; [|discriminate]. apply same_right in S. subst v. injection E as <-. split; assumption.
  Qed.
  Lemma without_unit_right t f : fits_unit t f -> without_unit (Some f) = true -> eval b t = eval a t.
  Proof.
    destruct f as [|u]; simpl; [intros [E F] _; congruence|]. intros E S. apply same_right in S. subst u. rewrite E, pure_factor. ring.
  Qed.

  Theorem unit_of_right t : forall f, unit_of us t = Some f -> fits_unit t f.
  Proof.
    induction t; simpl unit_of; intros h E.
    - (* Num *) injection E as <-. destruct (Z.eqb_spec z 0) as [->|]; simpl; [split; reflexivity|]. rewrite pure_factor. ring.
    - (* Const *) injection E as <-. reflexivity.
    - (* Coord *) injection E as <-. reflexivity.
    - (* Add *) destruct (unit_of us t1) as [f|], (unit_of us t2) as [g|]; try discriminate; try (destruct f; discriminate).
      destruct (common_right t1 t2 f g h (IHt1 f eq_refl) (IHt2 g eq_refl) E) as [H K].
      destruct h as [|u]; simpl in *; [destruct H as [-> ->], K as [-> ->]; split; ring|rewrite H, K; ring].
    - (* Sub *) destruct (unit_of us t1) as [f|], (unit_of us t2) as [g|]; try discriminate; try (destruct f; discriminate).
      destruct (common_right t1 t2 f g h (IHt1 f eq_refl) (IHt2 g eq_refl) E) as [H K].
      destruct h as [|u]; simpl in *; [destruct H as [-> ->], K as [-> ->]; split; ring|rewrite H, K; ring].
    - (* Mul *) destruct (unit_of us t1) as [f|], (unit_of us t2) as [g|]; try discriminate; [|destruct f; discriminate].
      specialize (IHt1 f eq_refl). specialize (IHt2 g eq_refl).
      destruct f as [|u], g as [|v]; injection E as <-; simpl in *.
      + destruct IHt1 as [-> ->], IHt2 as [-> ->]; split; ring.
      + destruct IHt1 as [-> ->]; split; ring.
      + destruct IHt2 as [-> ->]; split; ring.
      + rewrite IHt1, IHt2, factor_sum. ring.
    - (* Div *) destruct (unit_of us t1) as [f|], (unit_of us t2) as [g|]; try discriminate; [|destruct f; discriminate].
      specialize (IHt1 f eq_refl). specialize (IHt2 g eq_refl). destruct f as [|u], g as [|v]; try discriminate.
      + injection E as <-. simpl in *. destruct IHt1 as [-> ->]. unfold Rdiv. split; ring.
      + unfold less in E. destruct (same (sum (sum u (map Z.opp v)) v) u) eqn:S; [|discriminate]. injection E as <-. simpl in *.
        apply same_right in S. rewrite IHt1, IHt2. rewrite <- S at 1. rewrite factor_sum. unfold Rdiv. rewrite Rinv_mult.
        rewrite <- (Rmult_1_r (factor ks (sum u (map Z.opp v)) * (eval a t1 * / eval a t2))) at 1.
        rewrite <- (Rinv_r (factor ks v)) by (pose proof (factor_positive ks v); lra). ring.
    - (* Opp *) specialize (IHt h E). destruct h as [|u]; simpl in *; [destruct IHt as [-> ->]; split; ring|rewrite IHt; ring].
    - (* Pow *) destruct (unit_of us t) as [[|u]|]; try discriminate. injection E as <-. specialize (IHt _ eq_refl). simpl in *.
      rewrite IHt, Rpow_mult_distr, factor_times by exact P. reflexivity.
    - (* Sin *) destruct (unit_of us t) as [f|]; [|discriminate]. destruct (without_unit (Some f)) eqn:W; [|discriminate]. injection E as <-. simpl.
      rewrite (without_unit_right t f (IHt f eq_refl) W), pure_factor. ring.
    - (* Cos *) destruct (unit_of us t) as [f|]; [|discriminate]. destruct (without_unit (Some f)) eqn:W; [|discriminate]. injection E as <-. simpl.
      rewrite (without_unit_right t f (IHt f eq_refl) W), pure_factor. ring.
    - (* Sqrt *) destruct (unit_of us t) as [[|u]|]; try discriminate. unfold halved in E. specialize (IHt _ eq_refl). simpl in IHt.
      destruct (same _ u) eqn:S; [|discriminate]. injection E as <-. apply same_right in S. simpl. rewrite IHt. rewrite <- S at 1. rewrite factor_sum.
      set (h := map _ u). pose proof (factor_positive ks h). rewrite sqrt_mult_alt by (apply Rmult_le_pos; lra). rewrite sqrt_square by lra. reflexivity.
    - (* App *) destruct (unit_of us t) as [g|]; [|discriminate]. destruct (without_unit (Some g)) eqn:W; [|discriminate]. injection E as <-. simpl.
      rewrite (without_unit_right t g (IHt g eq_refl) W). reflexivity.
    - (* Ang *) destruct (unit_of us t1) as [f|], (unit_of us t2) as [g|]; try discriminate; try (destruct f; discriminate).
      destruct (common (Some f) (Some g)) as [[|u]|] eqn:C; try discriminate. injection E as <-.
      destruct (common_right t1 t2 f g _ (IHt1 f eq_refl) (IHt2 g eq_refl) C) as [H K]. simpl in *.
      rewrite H, K, T by apply factor_positive. rewrite pure_factor. ring.
  Qed.
End Measured.

Definition check_unit us x : option dimension :=
  if is_scalar x && is_real (single x) then match unit_of us (fst (single x)) with Some (One u) => Some u | _ => None end else None.
Lemma check_unit_right us x u : check_unit us x = Some u -> has_unit us x u.
Proof.
  unfold check_unit. destruct (is_scalar x) eqn:S, (is_real (single x)) eqn:R; simpl; try discriminate.
  destruct (unit_of us (fst (single x))) as [[|v]|] eqn:E; try discriminate. intros F. injection F as <-.
  split; [exact S|]. split; [exact R|]. intros scales a P T. exact (unit_of_right us scales a P T _ _ E).
Qed.
Definition check_units us x y : bool := match check_unit us x, check_unit us y with
  | Some u, Some v => Nat.eqb (length u) (length v) && negb (same u v) | _, _ => false end.
Theorem differ_by_units us x y : check_units us x y = true -> differ_in_unit us x y.
Proof.
  unfold check_units. destruct (check_unit us x) as [u|] eqn:E, (check_unit us y) as [v|] eqn:F; try discriminate.
  intros C. apply andb_prop in C as [L D]. apply Nat.eqb_eq in L. exists u, v. repeat split; try assumption.
  - intros ->. unfold same in D. destruct (list_eq_dec Z.eq_dec v v); [discriminate D|contradiction].
  - apply (check_unit_right us x u E).
  - apply (check_unit_right us x u E).
  - apply (check_unit_right us x u E); assumption.
  - apply (check_unit_right us y v F).
  - apply (check_unit_right us y v F).
  - apply (check_unit_right us y v F); assumption.
Qed.
Ltac by_units := apply differ_by_units; vm_cast_no_check (eq_refl true).
Ltac accepts_units := apply differ_by_units; vm_compute; reflexivity.

(** What has no entries, since the shapes of its parts do not fit, has no value. *)
Definition without_value (x : expr) := entries x = [].
Ltac by_shapes := vm_compute; reflexivity.
