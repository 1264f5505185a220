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

tests || { tail -n 40 "$copy/log"; echo "the tests fail without any change"; exit 2; }

survivors=0
while IFS= read -r line; do
    case "$line" in '' | '#'*) continue ;; esac
    [[ "$line" =~ ${1-} ]] || continue
    file=$(awk -F'[|]' '{ print $1 }' <<< "$line")
    MUTANT="$line" perl -0777 -i -pe '
        BEGIN { (undef, $from, $to) = map { s/\\\|/|/gr =~ s/\\n/\n/gr } split /(?<!\\)\|/, $ENV{MUTANT}; }
        s/\Q$from\E/$to/ or die "not found: $from\n"' "$copy/$file"
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
    cp "$file" "$copy/$file"
done < tests/oracle/mutants.txt
[ "$survivors" -eq 0 ] || { echo "$survivors mutants were not killed"; exit 1; }
