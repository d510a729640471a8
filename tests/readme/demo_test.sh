#!/usr/bin/env bash
# ./dev demo's report, by a tool that is built already: demo_test.sh TOOL
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
tool=$1
set -- help
# shellcheck source=../../dev
source "$root/dev" >/dev/null
demo_tool=$tool
demo_folder=$(mktemp -d)
trap 'rm -r "$demo_folder"' EXIT
pictures=()
compare_demo

fail() {
    printf 'FAILED: %s\n' "$*"
    exit 1
}
report=$demo_folder/demo/report.html
((${#pictures[@]} == 1)) || fail "the report is not told of"
[[ ${pictures[0]} == *"$report"* ]] || fail "the demo says '${pictures[0]}', not $report"
for method in exact blend stochastic mlab wboit; do
    grep -q "\"name\":\"$method\"" "$report" || fail "the report has no $method"
    [[ -s $demo_folder/demo/$method.s8.png ]] || fail "there is no picture of $method"
done
# What README and the help promise is what the demo says.
for text in README.md dev; do
    grep -q '\./dev demo .*\(report\|compare methods\)' "$root/$text" || fail "$text knows no report"
done
