# SPDX-License-Identifier: MIT
# Options, subcommands and values that --help tells of, and files. bash-completion loads this under
# each program's name; without it: source this file.

_openrt() {
    local program=${COMP_WORDS[0]} current=${COMP_WORDS[COMP_CWORD]} help subcommands word
    local before=${COMP_WORDS[COMP_CWORD - 1]} told=()
    program=${program/#~\//"$HOME"/}
    help=$("$program" --help 2>/dev/null) || return
    subcommands=$(sed -n '/^Subcommands:/,/^$/s/^  \([a-z][a-z-]*\) .*/\1/p' <<<"$help")
    for word in "${COMP_WORDS[@]:1:COMP_CWORD-1}"; do
        if grep -Fqx -e "$word" <<<"$subcommands"; then
            help=$("$program" "$word" --help 2>/dev/null)
            subcommands=
            break
        fi
    done
    case $before in
        --precision) told=(fast watertight precise) ;;
        --isa) told=(generic sse4 avx2 avx512 neon) ;;
        *)
            if [[ $current == -* ]]; then
                told=($(sed -n 's/^  \(-[^ {]*\).*/\1/p' <<<"$help" | tr , '\n'))
            else
                told=($subcommands)
            fi ;;
    esac
    COMPREPLY=($(compgen -W "${told[*]}" -- "$current"))
}
complete -o default -F _openrt openrt-info openrt-render openrt-view openrt-cave openrt-xr \
    openrt-trace openrt-bench openrt-accuracy openrt-conformance
