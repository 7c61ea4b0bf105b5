# SPDX-License-Identifier: MIT
# The options that --help tells of, and files. Loaded by bash-completion under each program's name.
complete -F _longopt openrt-info openrt-render openrt-view openrt-trace
