# SPDX-License-Identifier: MIT
# Options, subcommands and values that --help tells of, and files. bash-completion loads this under
# each program's name; without it: source this file.

_openrt() {
    local program=${COMP_WORDS[0]} current=${COMP_WORDS[COMP_CWORD]} help subcommands word
    local before=${COMP_WORDS[COMP_CWORD - 1]} told=() values= listed=
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
    if [[ $before =~ ^--[a-z-]+$ ]]; then
        values=$(sed -n "s/^  $before [^ {]*{\([^}]*\)}.*/\1/p" <<<"$help")
    fi
    if [[ $values ]]; then
        told=(${values//,/ })
        [[ $current == *,* ]] && listed=${current%,*},
    elif [[ $current == -* ]]; then
        told=($(sed -n 's/^  \(-[^ {]*\).*/\1/p' <<<"$help" | tr , '\n'))
    else
        told=($subcommands)
    fi
    COMPREPLY=($(compgen -P "$listed" -W "${told[*]}" -- "${current#"$listed"}"))
}
complete -o default -F _openrt openrt-info openrt-render openrt-view openrt-cave openrt-xr \
    openrt-trace openrt-bench openrt-accuracy openrt-conformance
