(** The words in which certificates are written: those of the block language. *)
From Certificate Require Export Check Analysis Refute Unit.
Local Open Scope R_scope.

(** ** Declarations *)
Definition parameter p := scalar (Const p).
Definition complex_number p q := Expr [[(Const p, Const q)]] [].
Definition coordinate p := scalar (Coord p 0).
Definition imaginary := Expr [[(Num 0, Num 1)]] [].
Definition function_ f k := apply_ f k.
Definition whole z := scalar (Num z).

(** A hypothesis about what is no real number says nothing. *)
Definition nothing := Positive (Num 1).
Definition about_real (f : term -> need) x := if is_scalar x && is_real (single x) then f (fst (single x)) else nothing.
Definition positive := about_real Positive.
Definition non_negative := about_real NonNegative.
Definition non_zero x := if is_scalar x then NonZero (norm (single x)) else nothing.

Definition real_parts := map (fun x => fst (single x)).
Definition given (directions : list term) (declared conditions : list need) := (directions, declared ++ conditions).
Definition power_minus x n := if is_scalar x then over_ (whole 1) (power_ x n) else power_ (inverse_ x) n.

Definition at_entry x i j := part x [i] [j].

(** ** Replacements: all at once; what is replaced may be a quantity or a value of a function *)
Definition put (l : list (term * term)) (t : term) : option term := option_map snd (find (fun e => if term_dec t (fst e) then true else false) l).
Definition fits (target value : expr) := is_scalar target && is_scalar value && (negb (is_real (single target)) || is_real (single value)).
Definition puts (l : list (expr * expr)) :=
  flat_map (fun '(q, v) => (fst (single q), fst (single v)) :: if is_real (single q) then [] else [(snd (single q), snd (single v))]) l.
Definition at_ x (l : list (expr * expr)) : expr :=
  if forallb (fun '(q, v) => fits q v) l then
    let r := replaced (put (puts l)) x in Expr (entries r) (needs r ++ flat_map (fun '(_, v) => needs v) l)
  else invalid.
(** The same expression with the arguments of functions in one form: Check.form_right says that its value is the same. *)
Definition settled (directions : list term) hypotheses references x :=
  let f := form directions hypotheses references (flat_map (fun c => [fst c; snd c]) (concat (entries x)) ++ map about (needs x)) in
  Expr (each (both f) (entries x)) (map (need_map f) (needs x)).

Declare Scope document_scope.
Delimit Scope document_scope with doc.
Bind Scope document_scope with expr.
Notation "x + y" := (plus_ x y) : document_scope.
Notation "x - y" := (minus_ x y) : document_scope.
Notation "- x" := (negative x) : document_scope.
Notation "x * y" := (times_ x y) : document_scope.
Notation "x / y" := (over_ x y) : document_scope.
Notation "x ^ n" := (power_ x n%N) : document_scope.
Notation "x 'at' l" := (at_ x l) (at level 90, l at level 9) : document_scope.
Notation "q |-> v" := (@pair expr expr q%doc v%doc) (at level 70) : document_scope.
Definition to_whole (x : expr) : option Z := match x with Expr [[(Num z, Num 0)]] [] => Some z | _ => None end.
Definition coefficient_by x q n := match to_whole n with Some z => coefficient_ x q (Z.to_nat z) | None => invalid end.
Number Notation expr whole to_whole : document_scope.

Notation sin := sin_. Notation cos := cos_. Notation tan := tan_. Notation cot := cot_. Notation sqrt := sqrt_. Notation angle := angle_.
Notation d := jacobian. Notation dt := dt_. Notation truncate := truncate_. Notation coefficient := coefficient_. Notation hurwitz := hurwitz_.
Notation det := det_. Notation transpose := transpose_. Notation inverse := inverse_. Notation adjugate := adj_. Notation trace := trace_.
Notation diagonal := diagonal_. Notation identity := identity_. Notation zero := null_. Notation row := row_. Notation column := column_.
Notation submatrix := part. Notation solve := solve_.
Arguments differ_in_unit us (x y)%doc. Arguments without_value x%doc.
Arguments equal a (x y)%doc. Arguments below a (x y)%doc. Arguments not_above a (x y)%doc.
Notation "h |= x == y" := (follows (fst h) (snd h) (fun a => equal a x%doc y%doc)) (at level 95, x at level 69, y at level 69).
Notation "h |= x < y" := (follows (fst h) (snd h) (fun a => below a x%doc y%doc)) (at level 95, x at level 69, y at level 69).
Notation "h |= x <= y" := (follows (fst h) (snd h) (fun a => not_above a x%doc y%doc)) (at level 95, x at level 69, y at level 69).
Notation "h |= x > y" := (follows (fst h) (snd h) (fun a => below a y%doc x%doc)) (at level 95, x at level 69, y at level 69).
Notation "h |= x >= y" := (follows (fst h) (snd h) (fun a => not_above a y%doc x%doc)) (at level 95, x at level 69, y at level 69).
Arguments differs a (x y)%doc. Arguments not_below a (x y)%doc. Arguments is_above a (x y)%doc.
Arguments Is x%doc q%Q. Arguments IsComplex x%doc (q r)%Q. Arguments Turns x%doc (c s)%Q. Arguments Takes f%doc vs.
Notation "h 'refutes' x == y" := (possible (fst h) (snd h) (fun a => differs a x%doc y%doc)) (at level 95, x at level 69, y at level 69).
Notation "h 'refutes' x < y" := (possible (fst h) (snd h) (fun a => not_below a x%doc y%doc)) (at level 95, x at level 69, y at level 69).
Notation "h 'refutes' x <= y" := (possible (fst h) (snd h) (fun a => is_above a x%doc y%doc)) (at level 95, x at level 69, y at level 69).
Notation "h 'refutes' x > y" := (possible (fst h) (snd h) (fun a => not_below a y%doc x%doc)) (at level 95, x at level 69, y at level 69).
Notation "h 'refutes' x >= y" := (possible (fst h) (snd h) (fun a => is_above a y%doc x%doc)) (at level 95, x at level 69, y at level 69).
