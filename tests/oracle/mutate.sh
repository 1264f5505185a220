#!/usr/bin/env bash
# Changes one line of the production code at a time, in a copy, and demands that a test fails.
#
# Usage: mutate.sh [PATTERN]; with a regular expression, only the mutants whose line matches it.
set -euo pipefail
cd "$(dirname "$0")/../.."

copy=$(mktemp -d)
trap 'rm -rf "$copy"' EXIT
git ls-files -z | xargs -0 cp --parents -t "$copy"
export CARGO_TARGET_DIR="${CARGO_TARGET_DIR:-$PWD/target}/mutants"
export CARGO_PROFILE_RELEASE_CODEGEN_UNITS=16

tests() {
    (cd "$copy" && cargo test --release --test oracle && cargo test --release --lib) \
        > "$copy/log" 2>&1
}

mutants() { grep -v '^#' tests/oracle/mutants.txt | grep -E -- "${1-}"; }

# Puts a mutant into the copy; fails if its line is no longer there.
mutate() {
    MUTANT="$1" perl -0777 -i -pe '
        BEGIN { (undef, $from, $to) = map { s/\\\|/|/gr =~ s/\\n/\n/gr } split /(?<!\\)\|/, $ENV{MUTANT}; }
        s/\Q$from\E/$to/ or die "not found: $ENV{MUTANT}\n"' "$copy/$2"
}

restore() { cp "$1" "$copy/$1"; }

# All that can be found wrong in seconds comes before what takes half an hour.
missing=0
while IFS= read -r line; do
    mutate "$line" "${line%%|*}" || missing=1
    restore "${line%%|*}"
done < <(mutants "$@")
[ "$missing" -eq 0 ] || exit 2

tests || { tail -n 40 "$copy/log"; echo "the tests fail without any change"; exit 2; }

survivors=0
while IFS= read -r line; do
    file=${line%%|*}
    mutate "$line" "$file"
    if tests; then
        echo "SURVIVED  $line"
        survivors=$((survivors + 1))
    elif grep -q "^error.*could not compile" "$copy/log"; then
        echo "INVALID   $line"
        grep -m 3 -A 5 "^error" "$copy/log"
        survivors=$((survivors + 1))
    else
        echo "killed    $line  ($(grep -c "[.][.][.] FAILED$" "$copy/log") tests)"
    fi
    restore "$file"
done < <(mutants "$@")
[ "$survivors" -eq 0 ] || { echo "$survivors mutants were not killed"; exit 1; }
