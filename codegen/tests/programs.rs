//! Programs and their inputs.

use sextic_codegen::arithmetic::doubles::evaluate;
use sextic_codegen::program::{Operation, Program};

/// b − a·a, whose inputs c, b and a were met in this order, c for nothing.
fn met_late() -> Program {
    let mut program = Program::default();
    program.add_input("c");
    let b = program.add_input("b");
    let two = program.constant(2.into());
    let a = program.add_input("a");
    let square = program.push(Operation::Multiply(a, a));
    let difference = program.push(Operation::Subtract(b, square));
    program.output("y", difference);
    program.output("two", two);
    program
}

#[test]
fn inputs_come_first_in_the_order_that_is_asked_for() {
    let program = met_late().with_inputs_first(&["a", "b"]);
    assert_eq!(program.inputs(), ["a", "b", "c"]);
    assert!(
        program.operations()[..3]
            .iter()
            .enumerate()
            .all(|(place, operation)| *operation == Operation::Input(place as u32))
    );
    assert_eq!(evaluate(&program, &[3.0, 11.0, 0.5]), Some(vec![2.0, 2.0]));
}

#[test]
fn inputs_that_nothing_rests_on_go() {
    let program = met_late()
        .with_inputs_first(&["a", "b"])
        .without_idle_inputs();
    assert_eq!(program.inputs(), ["a", "b"]);
    assert_eq!(evaluate(&program, &[3.0, 11.0]), Some(vec![2.0, 2.0]));
    let program = program.without_idle_inputs();
    assert_eq!(program.inputs(), ["a", "b"], "all are busy");
    let mut constant = Program::new(["x".to_owned()]);
    let one = constant.constant(1.into());
    constant.output("y", one);
    assert!(constant.without_idle_inputs().inputs().is_empty());
}
