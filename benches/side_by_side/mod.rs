//! Contenders that take turns, so that what disturbs the machine disturbs all of them.

use std::time::Instant;

/// How many turns everyone has.
const ROUNDS: usize = 301;

/// How long a turn takes, at least.
const NANOSECONDS: u128 = 50_000;

/// Something to be timed.
pub struct Contender<'a> {
    name: String,
    points: usize,
    run: Box<dyn FnMut() + 'a>,
    /// How often it runs in a turn.
    repeats: usize,
    /// Nanoseconds a point, one number a turn.
    turns: Vec<f64>,
}

impl<'a> Contender<'a> {
    /// What computes that many points in a run.
    pub fn new(name: impl Into<String>, points: usize, run: impl FnMut() + 'a) -> Self {
        Contender {
            name: name.into(),
            points,
            run: Box::new(run),
            repeats: 1,
            turns: Vec::new(),
        }
    }

    fn nanoseconds(&mut self) -> u128 {
        let start = Instant::now();
        for _ in 0..self.repeats {
            (self.run)();
        }
        start.elapsed().as_nanos()
    }

    fn warm_up(&mut self) {
        while self.nanoseconds() < NANOSECONDS {
            self.repeats *= 2;
        }
    }

    fn turn(&mut self) {
        let nanoseconds = self.nanoseconds() as f64;
        self.turns
            .push(nanoseconds / (self.repeats * self.points) as f64);
    }
}

fn sorted(mut values: Vec<f64>) -> Vec<f64> {
    values.sort_by(f64::total_cmp);
    values
}

/// Times all of them and prints nanoseconds a point, at best and in the median, and the median over the
/// turns of how often each of them goes into the first one.
pub fn compare(title: &str, mut contenders: Vec<Contender<'_>>) {
    for contender in &mut contenders {
        contender.warm_up();
    }
    for _ in 0..ROUNDS {
        for contender in &mut contenders {
            contender.turn();
        }
    }
    println!("{title:<42}{:>12}{:>12}{:>12}", "best", "median", "ratio");
    let first = contenders[0].turns.clone();
    for contender in &contenders {
        let ratios = first.iter().zip(&contender.turns);
        let ratios = sorted(ratios.map(|(first, turn)| first / turn).collect());
        let turns = sorted(contender.turns.clone());
        println!(
            "  {:<40}{:>9.2} ns{:>9.2} ns{:>11.2}x",
            contender.name,
            turns[0],
            turns[ROUNDS / 2],
            ratios[ROUNDS / 2]
        );
    }
}
