#!/usr/bin/env bash
# Times `sextic audit` as a process, from start to exit: median, least and most of some runs.
#
#     benches/audit.sh [RUNS [DOC…]]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

runs=${1:-25}
cargo build --release --quiet
command=${CARGO_TARGET_DIR:-target}/release/sextic

for ((run = 0; run < runs; run++)); do
    start=${EPOCHREALTIME/[.,]/}
    "$command" audit "${@:2}" >/dev/null
    echo $((${EPOCHREALTIME/[.,]/} - start))
done | sort -n | awk '
    { time[NR] = $1 / 1000 }
    END { printf "sextic audit: median %.1f ms, least %.1f ms, most %.1f ms of %d runs\n",
              time[int((NR + 1) / 2)], time[1], time[NR], NR }'
