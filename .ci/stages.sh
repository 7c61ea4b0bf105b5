# SPDX-License-Identifier: MIT
# Stages of ./check: what each took, and what became of it. To be sourced.
stage_times=()
stage_failures=()

# stage NAME COMMAND...: runs it, and returns what it returned.
stage() {
    local name=$1 started=$SECONDS status=0
    shift
    echo "== $name"
    "$@" || status=$?
    stage_times+=("$(printf '%6d s  %s' $((SECONDS - started)) "$name")")
    [ $status -eq 0 ] || stage_failures+=("$name")
    return $status
}

# is_here TOOL NAME: whether there is what the stage takes. The stage counts as failed if not, unless
# OPENRT_WITHOUT names the tool.
is_here() {
    case $1 in
        root) [ "$EUID" -eq 0 ] && return 0 ;;
        *) command -v "$1" >/dev/null && return 0 ;;
    esac
    echo "== $2: not run without $1"
    [[ " ${OPENRT_WITHOUT:-} " == *" $1 "* ]] || stage_failures+=("$2, not run without $1")
    return 1
}

# end_stages [MINUTES]: tells the times; whether nothing failed, and all together took no longer.
end_stages() {
    local minutes=${1:-}
    printf '%s\n' "${stage_times[@]}" "$(printf '%6d s  all' $SECONDS)"
    if [ -n "$minutes" ] && [ $SECONDS -gt $((60 * minutes)) ]; then
        stage_failures+=("more than $minutes minutes")
    fi
    [ ${#stage_failures[@]} -gt 0 ] || return 0
    printf 'failed: %s\n' "${stage_failures[@]}" >&2
    return 1
}
