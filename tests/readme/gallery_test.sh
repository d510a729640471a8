#!/usr/bin/env bash
# ./dev gallery's page, small, by a tool that is built already: gallery_test.sh TOOL
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
tool=$1
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT

fail() {
    printf 'FAILED: %s\n' "$*"
    exit 1
}
python3 -B "$root/scripts/gallery.py" --tool "$tool" --size 12x12 "$folder/gallery.md"
# `none` draws nothing; names stand alone at the beginnings of lines.
methods=$("$tool" methods --json | sed -n 's/^ *"id": "\(.*\)",$/\1/p' | grep -vx none)
(($(wc -l <<<"$methods") > 20)) || fail "too few methods: $methods"
for method in $methods truth; do
    [[ -s $folder/pictures/gallery/$method.png ]] || fail "there is no picture of $method"
    grep -qF "(pictures/gallery/$method.png)" "$folder/gallery.md" || fail "the page has no $method"
done
