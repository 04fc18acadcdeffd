(** What an expression of a document is, and what it is worth: everything that a reader has to believe.

    A document speaks of real numbers. An [assignment] gives each quantity a value; [eval] gives a [term] its
    value by the operations of Coq's real numbers, with the sine, the cosine and the root of its library.
    Complex numbers are pairs of terms, matrices are lists of rows; a single number is a matrix of one entry.
    Beside its entries an [expr] has its [needs]: what must not be 0, or not be negative, for it to have a value. *)
Require Export Reals ZArith List Bool.
Export ListNotations.
Open Scope R_scope.

Inductive term :=
  | Num (z : Z)                                (* a whole number *)
  | Const (p : positive)                       (* a parameter or an angle; a complex one is two of them *)
  | Coord (p : positive) (k : nat)             (* the k-th time derivative of a coordinate *)
  | Add (s t : term) | Sub (s t : term) | Mul (s t : term) | Div (s t : term) | Opp (t : term)
  | Pow (t : term) (n : N)
  | Sin (t : term) | Cos (t : term) | Sqrt (t : term)
  | App (f : positive) (k : nat) (t : term)    (* the k-th derivative of a function, at t *)
  | Ang (x y : term).                          (* the angle of the vector (x, y) *)

Record assignment := Assignment {
  constant : positive -> R;
  coordinate : positive -> nat -> R;
  function : positive -> nat -> R -> R;
  direction : R -> R -> R }.

Fixpoint eval (a : assignment) (t : term) : R :=
  match t with
  | Num z => IZR z
  | Const p => constant a p
  | Coord p k => coordinate a p k
  | Add s t => eval a s + eval a t
  | Sub s t => eval a s - eval a t
  | Mul s t => eval a s * eval a t
  | Div s t => eval a s / eval a t
  | Opp t => - eval a t
  | Pow t n => eval a t ^ N.to_nat n
  | Sin t => sin (eval a t)
  | Cos t => cos (eval a t)
  | Sqrt t => sqrt (eval a t)
  | App f k t => function a f k (eval a t)
  | Ang x y => direction a (eval a x) (eval a y)
  end.

(** A condition on an assignment: a declaration, an assumption, what a division needs. *)
Inductive need := NonZero (t : term) | Positive (t : term) | NonNegative (t : term).
Definition met (a : assignment) (n : need) : Prop :=
  match n with
  | NonZero t => eval a t <> 0
  | Positive t => 0 < eval a t
  | NonNegative t => 0 <= eval a t
  end.

(** The angle of a vector along (cos β, sin β) is β, for the angles β that a certificate names. *)
Definition along (branches : list term) (a : assignment) : Prop :=
  Forall (fun b => forall w, 0 < w -> direction a (w * cos (eval a b)) (w * sin (eval a b)) = eval a b) branches.

(** ** Operations that leave out what is 0 or 1 *)
Definition is0 (t : term) := match t with Num 0 => true | _ => false end.
Definition is1 (t : term) := match t with Num 1 => true | _ => false end.
Definition add s t := if is0 s then t else if is0 t then s else Add s t.
Definition opp t := match t with Num z => Num (- z) | Opp s => s | _ => Opp t end.
Definition sub s t := if is0 t then s else if is0 s then opp t else Sub s t.
Definition mul s t :=
  if is0 s || is0 t then Num 0 else if is1 s then t else if is1 t then s else Mul s t.
Definition div s t := if is0 s then Num 0 else if is1 t then s else Div s t.
Definition pow t n := match n with 0%N => Num 1 | 1%N => t | _ => if is0 t then Num 0 else if is1 t then t else Pow t n end.
Definition sine t := if is0 t then Num 0 else Sin t.
Definition cosine t := if is0 t then Num 1 else Cos t.
Definition root t := if is0 t then Num 0 else if is1 t then Num 1 else Sqrt t.

(** ** Complex numbers: real and imaginary part *)
Definition complex : Type := term * term.
Definition real t : complex := (t, Num 0).
Definition is_real (c : complex) := is0 (snd c).
Definition cadd (c d : complex) : complex := (add (fst c) (fst d), add (snd c) (snd d)).
Definition csub (c d : complex) : complex := (sub (fst c) (fst d), sub (snd c) (snd d)).
Definition copp (c : complex) : complex := (opp (fst c), opp (snd c)).
Definition cmul (c d : complex) : complex :=
  (sub (mul (fst c) (fst d)) (mul (snd c) (snd d)), add (mul (fst c) (snd d)) (mul (snd c) (fst d))).
Definition norm (c : complex) := if is_real c then fst c else add (pow (fst c) 2) (pow (snd c) 2).
Definition cdiv (c d : complex) : complex :=
  if is_real d then (div (fst c) (fst d), div (snd c) (fst d))
  else let n := cmul c (fst d, opp (snd d)) in (div (fst n) (norm d), div (snd n) (norm d)).
Fixpoint cpow_nat (c : complex) (n : nat) : complex :=
  match n with O => real (Num 1) | 1%nat => c | S n => cmul c (cpow_nat c n) end.
Definition cpow (c : complex) (n : N) : complex :=
  if is_real c then (pow (fst c) n, Num 0) else cpow_nat c (N.to_nat n).
Definition zero_ := real (Num 0).
Definition one_ := real (Num 1).
Definition is_zero (c : complex) := is0 (fst c) && is0 (snd c).

(** ** Matrices: lists of rows *)
Definition matrix := list (list complex).
Fixpoint zip {A B C} (f : A -> B -> C) (u : list A) (v : list B) : list C :=
  match u, v with a :: u, b :: v => f a b :: zip f u v | _, _ => [] end.
Definition rows (m : matrix) := length m.
Definition columns (m : matrix) := length (hd [] m).
Definition each (f : complex -> complex) : matrix -> matrix := map (map f).
Definition entry (m : matrix) i j := nth j (nth i m []) zero_.       (* counted from 0 *)
Definition build n k (f : nat -> nat -> complex) : matrix :=
  map (fun i => map (fun j => f i j) (seq 0 k)) (seq 0 n).
Definition transposed (m : matrix) := build (columns m) (rows m) (fun i j => entry m j i).
Definition dot (u v : list complex) := fold_right cadd zero_ (zip cmul u v).
Definition product (m n : matrix) := let t := transposed n in map (fun r => map (dot r) t) m.
Fixpoint without {A} (k : nat) (l : list A) :=
  match k, l with O, _ :: l => l | S k, a :: l => a :: without k l | _, [] => [] end.
(** Laplace's expansion by the first row *)
Fixpoint laplace (n : nat) (m : matrix) : complex :=
  match n, m with
  | S n, r :: rest =>
      (fix along_row k (positive_sign : bool) r := match r with
        | [] => zero_
        | c :: r => let others := along_row (S k) (negb positive_sign) r in
            if is_zero c then others
            else cadd (cmul (if positive_sign then c else copp c) (laplace n (map (without k) rest))) others
        end) O true r
  | _, _ => one_
  end.
Definition determinant_ (m : matrix) := laplace (rows m) m.
Definition minor_ (m : matrix) i j := determinant_ (map (without j) (without i m)).
Definition adjugate_ (m : matrix) :=
  build (rows m) (rows m) (fun i j => if Nat.even (i + j) then minor_ m j i else copp (minor_ m j i)).

(** ** Expressions. One whose shapes do not fit has no entries, and no statement about it is true. *)
Record expr := Expr { entries : matrix; needs : list need }.
Definition invalid := Expr [] [].
Definition scalar t := Expr [[real t]] [].
Definition is_scalar (e : expr) := Nat.eqb (rows (entries e)) 1 && Nat.eqb (columns (entries e)) 1.
Definition single (e : expr) := entry (entries e) 0 0.
Definition same_shape (x y : matrix) := Nat.eqb (rows x) (rows y) && Nat.eqb (columns x) (columns y) && negb (Nat.eqb (rows x) 0).
Definition plus_ x y :=
  if same_shape (entries x) (entries y) then Expr (zip (zip cadd) (entries x) (entries y)) (needs x ++ needs y) else invalid.
Definition minus_ x y :=
  if same_shape (entries x) (entries y) then Expr (zip (zip csub) (entries x) (entries y)) (needs x ++ needs y) else invalid.
Definition negative x := Expr (each copp (entries x)) (needs x).
Definition times_ x y :=
  if is_scalar x then Expr (each (cmul (single x)) (entries y)) (needs x ++ needs y)
  else if is_scalar y then Expr (each (fun c => cmul c (single y)) (entries x)) (needs x ++ needs y)
  else if Nat.eqb (columns (entries x)) (rows (entries y)) && negb (Nat.eqb (rows (entries x)) 0)
    then Expr (product (entries x) (entries y)) (needs x ++ needs y) else invalid.
Definition over_ x y :=
  if is_scalar y then Expr (each (fun c => cdiv c (single y)) (entries x)) (needs x ++ needs y ++ [NonZero (norm (single y))])
  else invalid.
Definition is_square (x : expr) := same_shape (entries x) (transposed (entries x)).
Fixpoint matrix_power (m : matrix) (n : nat) : matrix :=
  match n with
  | O => build (rows m) (rows m) (fun i j => if Nat.eqb i j then one_ else zero_)
  | 1%nat => m
  | S n => product m (matrix_power m n)
  end.
Definition power_ x (n : N) :=
  if is_scalar x then Expr [[cpow (single x) n]] (needs x)
  else if is_square x then Expr (matrix_power (entries x) (N.to_nat n)) (needs x) else invalid.
Definition fraction (p q : Z) := over_ (scalar (Num p)) (scalar (Num q)).

Definition on_real (x : expr) (f : term -> term) (more : term -> list need) :=
  if is_scalar x && is_real (single x) then Expr [[real (f (fst (single x)))]] (needs x ++ more (fst (single x))) else invalid.
Definition sin_ x := on_real x sine (fun _ => []).
Definition cos_ x := on_real x cosine (fun _ => []).
Definition tan_ x := on_real x (fun t => div (sine t) (cosine t)) (fun t => [NonZero (cosine t)]).
Definition cot_ x := on_real x (fun t => div (cosine t) (sine t)) (fun t => [NonZero (sine t)]).
Definition sqrt_ x := on_real x root (fun t => [NonNegative t]).
Definition apply_ f k x := on_real x (App f k) (fun _ => []).
Definition angle_ x y :=
  if is_scalar x && is_real (single x) && is_scalar y && is_real (single y) then
    let u := fst (single x) in let v := fst (single y) in
    Expr [[real (Ang u v)]] (needs x ++ needs y ++ [NonZero (add (pow u 2) (pow v 2))])
  else invalid.

Definition transpose_ x := Expr (transposed (entries x)) (needs x).
Definition det_ x := if is_square x then Expr [[determinant_ (entries x)]] (needs x) else invalid.
Definition trace_ x :=
  if is_square x then Expr [[fold_right cadd zero_ (map (fun i => entry (entries x) i i) (seq 0 (rows (entries x))))]] (needs x) else invalid.
Definition adj_ x := if is_square x then Expr (adjugate_ (entries x)) (needs x) else invalid.
Definition inverse_ x := over_ (adj_ x) (det_ x).
Definition solve_ x y := times_ (inverse_ x) y.
Definition identity_ n := Expr (build n n (fun i j => if Nat.eqb i j then one_ else zero_)) [].
Definition null_ n k := Expr (build n k (fun _ _ => zero_)) [].
Definition every (l : list expr) := flat_map needs l.
Definition diagonal_ (l : list expr) :=
  if forallb is_scalar l
  then Expr (build (length l) (length l) (fun i j => if Nat.eqb i j then single (nth i l invalid) else zero_)) (every l) else invalid.
(** Blocks side by side, and one above the other *)
Definition beside x y :=
  if Nat.eqb (rows (entries x)) (rows (entries y)) && negb (Nat.eqb (rows (entries x)) 0)
  then Expr (zip (@app complex) (entries x) (entries y)) (needs x ++ needs y) else invalid.
Definition above x y :=
  if Nat.eqb (columns (entries x)) (columns (entries y)) && negb (Nat.eqb (rows (entries x)) 0) && negb (Nat.eqb (rows (entries y)) 0)
  then Expr (entries x ++ entries y) (needs x ++ needs y) else invalid.
Definition fold1 (f : expr -> expr -> expr) (l : list expr) :=
  match rev l with [] => invalid | x :: l => fold_left (fun e y => f y e) l x end.
Definition blocks (l : list (list expr)) := fold1 above (map (fold1 beside) l).
(** Parts, counted from 1 *)
Definition within (m : matrix) (I J : list nat) :=
  forallb (fun i => Nat.leb 1 i && Nat.leb i (rows m)) I && forallb (fun j => Nat.leb 1 j && Nat.leb j (columns m)) J
  && negb (Nat.eqb (length I) 0) && negb (Nat.eqb (length J) 0).
Definition part x I J :=
  if within (entries x) I J
  then Expr (map (fun i => map (fun j => entry (entries x) (pred i) (pred j)) J) I) (needs x) else invalid.
Definition row_ x i := part x [i] (seq 1 (columns (entries x))).
Definition column_ x j := part x (seq 1 (rows (entries x))) [j].
(** The n-th entry of a row or a column *)
Definition component x n := if Nat.eqb (columns (entries x)) 1 then part x [n] [1%nat] else if Nat.eqb (rows (entries x)) 1 then part x [1%nat] [n] else invalid.

(** ** Statements *)
Definition cvalue a (c : complex) := (eval a (fst c), eval a (snd c)).
Definition value a (x : expr) := map (map (cvalue a)) (entries x).
(** Both sides have values under the assignment, and these are equal. *)
Definition equal a x y :=
  same_shape (entries x) (entries y) = true /\ Forall (met a) (needs x ++ needs y) /\ value a x = value a y.
(** Both have real values, and y is above x, or not below it. *)
Definition comparable x y := is_scalar x && is_scalar y && is_real (single x) && is_real (single y) = true.
Definition below a x y :=
  comparable x y /\ Forall (met a) (needs x ++ needs y) /\ eval a (fst (single x)) < eval a (fst (single y)).
Definition not_above a x y :=
  comparable x y /\ Forall (met a) (needs x ++ needs y) /\ eval a (fst (single x)) <= eval a (fst (single y)).
(** Whatever satisfies the hypotheses satisfies the statement. *)
Definition follows (branches : list term) (hypotheses : list need) (statement : assignment -> Prop) :=
  forall a, along branches a -> Forall (met a) hypotheses -> statement a.
