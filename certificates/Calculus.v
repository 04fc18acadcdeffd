(** Replacements and derivatives of expressions. What they are is said here by functions; that these are the
    replacement of a value and the derivative of real analysis is proved in Analysis.v. *)
From Certificate Require Export Term.

(** [subst f t] has [f] of a quantity where [t] has the quantity, all at once. *)
Fixpoint subst (f : term -> option term) (t : term) : term :=
  match f t with Some v => v | None =>
  match t with
  | Num _ | Const _ | Coord _ _ => t
  | Add s t => add (subst f s) (subst f t)
  | Sub s t => sub (subst f s) (subst f t)
  | Mul s t => mul (subst f s) (subst f t)
  | Div s t => div (subst f s) (subst f t)
  | Opp t => opp (subst f t)
  | Pow t n => pow (subst f t) n
  | Sin t => sine (subst f t)
  | Cos t => cosine (subst f t)
  | Sqrt t => root (subst f t)
  | App g k t => App g k (subst f t)
  | Ang x y => Ang (subst f x) (subst f y)
  end end.

(** [D f t] is the derivative of [t] along a motion in which a quantity has the rate that [f] says. *)
Fixpoint D (f : term -> term) (t : term) : term :=
  match t with
  | Num _ => Num 0
  | Const _ | Coord _ _ => f t
  | Add s t => add (D f s) (D f t)
  | Sub s t => sub (D f s) (D f t)
  | Mul s t => add (mul (D f s) t) (mul s (D f t))
  | Div s t => sub (div (D f s) t) (div (mul s (D f t)) (pow t 2))
  | Opp t => opp (D f t)
  | Pow t n => mul (mul (Num (Z.of_N n)) (pow t (N.pred n))) (D f t)
  | Sin t => mul (cosine t) (D f t)
  | Cos t => opp (mul (sine t) (D f t))
  | Sqrt t => div (D f t) (mul (Num 2) (root t))
  | App g k t => mul (App g (S k) t) (D f t)
  | Ang x y => div (sub (mul x (D f y)) (mul y (D f x))) (add (pow x 2) (pow y 2))
  end.
Fixpoint moving_roots (f : term -> term) (t : term) : list term :=
  match t with
  | Num _ | Const _ | Coord _ _ => []
  | Add s t | Sub s t | Mul s t | Div s t | Ang s t => moving_roots f s ++ moving_roots f t
  | Opp t | Pow t _ | Sin t | Cos t | App _ _ t => moving_roots f t
  | Sqrt t => if is0 (D f t) then moving_roots f t else t :: moving_roots f t
  end.

Definition both {A} (f : term -> A) (c : complex) := (f (fst c), f (snd c)).
Definition radicands f (x : expr) := map Positive (flat_map (flat_map (fun c => moving_roots f (fst c) ++ moving_roots f (snd c))) (entries x)).
Definition derivative f (x : expr) := Expr (each (both (D f)) (entries x)) (needs x ++ radicands f x).

(** The derivative by time: what moves are the coordinates. *)
Definition rate (t : term) := match t with Coord p k => Coord p (S k) | _ => Num 0 end.
Definition dt_ := derivative rate.

Definition same (s t : term) : bool := match s, t with
  | Const p, Const q => Pos.eqb p q
  | Coord p k, Coord q l => Pos.eqb p q && Nat.eqb k l
  | _, _ => false end.
Definition is_leaf t := match t with Const _ | Coord _ _ => true | _ => false end.
(** The derivative by one quantity, and the matrix of those of a column by several *)
Definition d_ (x q : expr) :=
  if is_scalar q && is_real (single q) && is_leaf (fst (single q))
  then derivative (fun t => if same t (fst (single q)) then Num 1 else Num 0) x else invalid.
Definition flattened (q : expr) := map (fun c => Expr [[c]] []) (concat (entries q)).
Definition jacobian (x q : expr) :=
  if is_scalar q then d_ x q
  else if Nat.eqb (columns (entries x)) 1
    then let e := fold1 beside (map (d_ (Expr (entries x) [])) (flattened q)) in Expr (entries e) (needs x ++ needs e) else invalid.

(** Replacements: quantities, real and imaginary parts of complex ones, values of functions *)
Definition need_map (f : term -> term) (n : need) := match n with NonZero t => NonZero (f t) | Positive t => Positive (f t) | NonNegative t => NonNegative (f t) end.
Definition replaced (f : term -> option term) (x : expr) := Expr (each (both (subst f)) (entries x)) (map (need_map (subst f)) (needs x)).

Definition factorial (n : nat) := Z.of_nat (fact n).
Fixpoint derivatives (f : term -> term) (n : nat) (t : term) := match n with O => [t] | S n => t :: derivatives f n (D f t) end.
(** The quantity that marks what is small; no document has it. *)
Definition mark := Const 1.
Definition by_mark t := match t with Const 1 => Num 1 | _ => Num 0 end.
Definition at_mark_0 t := match t with Const 1 => Some (Num 0) | _ => None end.
(** Taylor's coefficients of a term in the mark, those of order 0 to n *)
Definition taylor n t := zip (fun k t => div (subst at_mark_0 t) (Num (factorial k))) (seq 0 (S n)) (derivatives by_mark n t).
Definition marked (small : list term) t := if existsb (same t) small then Some (mul mark t) else None.
Definition sum := fold_right add (Num 0).
Definition leaves_of (q : expr) := flat_map (fun c => fst c :: if is_real c then [] else [snd c]) (concat (entries q)).
Definition truncate_ (x q : expr) n :=
  if forallb is_leaf (leaves_of q) then
    let m := replaced (marked (leaves_of q)) x in
    Expr (each (both (fun t => sum (taylor n t))) (entries m)) (map (need_map (subst at_mark_0)) (needs m ++ radicands by_mark m))
  else invalid.
(** The coefficient of the n-th power of a quantity, for a polynomial in it: Taylor's at 0. Of a complex quantity
    the real values are enough. *)
Definition only_mark (q : expr) t := if same t (fst (single q)) then Some mark else if same t (snd (single q)) then Some (Num 0) else None.
Definition coefficient_ (x q : expr) n :=
  if is_scalar q && is_leaf (fst (single q)) then
    Expr (each (both (fun t => nth n (taylor n t) (Num 0))) (entries (replaced (only_mark q) x))) (needs x)
  else invalid.
(** Hurwitz' determinants of a polynomial of a degree that is told *)
Definition hurwitz_ (x q : expr) degree n :=
  let c k := if Nat.leb k degree then coefficient_ x q k else scalar (Num 0) in
  let below_zero i j := Nat.ltb degree (2 * j - i) || Nat.ltb (2 * j) i in
  det_ (blocks (map (fun i => map (fun j => if below_zero i j then scalar (Num 0) else c (degree - (2 * j - i))%nat) (seq 1 n)) (seq 1 n))).
