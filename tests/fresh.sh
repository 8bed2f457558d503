#!/usr/bin/env bash
# Runs the README's commands in a bare root tree of a Debian release, which has only git, sudo and certificates.
#
#   tests/fresh.sh                     run.sh and test.sh in Debian 12 and 13, run.sh in the next release
#   tests/fresh.sh RELEASE             run.sh and test.sh in a tree of this release (bookworm, trixie, forky)
#   tests/fresh.sh RELEASE COMMAND     only this line of bash, in a fresh clone, such as './run.sh run classic --seconds 1'
#   tests/fresh.sh --quick             the quick suites and run.sh in the release that this computer does not run: 12 on 13, else 13
#
# Clones HEAD of this checkout, without uncommitted changes. Needs mmdebstrap, and root or a kernel with user namespaces.
# Unpacks trees into MELTPOOL_TREES (default ~/.cache/meltpool/trees), uses existing ones, and removes them at the end
# unless MELTPOOL_KEEP_TREE=1. Logs are next to the trees: RELEASE.log.
set -euo pipefail
cd "$(dirname "$0")/.."

readonly trees=${MELTPOOL_TREES:-${XDG_CACHE_HOME:-${HOME:-/tmp}/.cache}/meltpool/trees}
readonly start='./run.sh run classic --seconds 1'
readonly nextRelease=forky

# inNamespace COMMAND...: runs it as root in new namespaces, so that its mounts and processes end with it.
inNamespace() {
    if [ "$(id -u)" -eq 0 ]; then
        unshare --mount --pid --fork --kill-child "$@"
    else
        mmdebstrap --unshare-helper unshare --mount --pid --fork --kill-child "$@"
    fi
}

# makeTree RELEASE: unpacks the bare tree, once.
makeTree() {
    local release=$1 tree=$trees/$1
    [ -e "$tree/.complete" ] && return
    command -v mmdebstrap >/dev/null || {
        echo "tests/fresh.sh: mmdebstrap is missing; install it first" >&2
        exit 2
    }
    mkdir -p "$trees"
    echo "Unpacking a bare tree of $release into $tree"
    rm -rf "$tree"
    # force-unsafe-io: a test tree need not survive a power cut. Check-Valid-Until: lists of an unreleased Debian may be old.
    mmdebstrap --quiet --variant=minbase --include=git,sudo,ca-certificates --dpkgopt=force-unsafe-io \
        --aptopt='Acquire::Check-Valid-Until "false"' --aptopt='Acquire::Retries "3"' "$release" "$tree" </dev/null
    : >"$tree/.complete"
}

# inTree RELEASE CLONE COMMAND: runs a line of bash in the clone inside the tree. Of the environment it passes only CI.
inTree() {
    local release=$1 clone=$2 command=$3
    # shellcheck disable=SC2016
    inNamespace bash -c 'set -e
        tree=$1 clone=$2 command=$3 packages=$4 ci=$5
        mount -t proc proc "$tree/proc"
        mount --rbind /dev "$tree/dev"
        mount --rbind /sys "$tree/sys"
        mount -t tmpfs -o mode=1777 tmpfs "$tree/tmp"
        mkdir -p "$tree/src" "$packages"
        mount --bind "$packages" "$tree/var/cache/apt/archives"
        mount --bind "$clone" "$tree/src"
        cp -L /etc/resolv.conf "$tree/etc/resolv.conf" 2>/dev/null || true
        exec chroot "$tree" /usr/bin/env -i PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin HOME=/root \
            LANG=C.UTF-8 ${ci:+CI="$ci"} bash -c "cd /src/meltpool && $command"' \
        inTree "$trees/$release" "$clone" "$command" "$trees/packages-$release" "${CI:-}" </dev/null
}

# tryRelease RELEASE COMMAND...: runs the lines of bash in turn, in one clone with one log, up to the first that fails.
tryRelease() {
    local release=$1 log=$trees/$1.log command clone failed=
    shift
    makeTree "$release"
    clone=$(mktemp -d "$trees/clone.XXXXXX")
    git clone --quiet --no-local . "$clone/meltpool"
    : >"$log"
    for command in "$@"; do
        echo "$release: $command (log: $log)"
        inTree "$release" "$clone" "$command" >>"$log" 2>&1 && continue
        failed=$command
        break
    done
    rm -rf "$clone"
    [ -n "${MELTPOOL_KEEP_TREE:-}" ] || rm -rf "${trees:?}/$release"
    if [ -n "$failed" ]; then
        tail -n 60 "$log" >&2
        echo "tests/fresh.sh: $release: $failed failed" >&2
        return 1
    fi
    grep -E 'tests passed|ended|written' "$log" | tail -n 3 || true
}

# Prints the stable or old release that this computer does not run.
otherRelease() {
    # shellcheck disable=SC1091
    case $(. /etc/os-release && echo "${VERSION_CODENAME:-}") in
    trixie) echo bookworm ;;
    *) echo trixie ;;
    esac
}

case ${1:-} in
--quick) tryRelease "$(otherRelease)" './test.sh --quick' "$start" ;;
'')
    tryRelease bookworm "$start" ./test.sh
    tryRelease trixie "$start" ./test.sh
    tryRelease $nextRelease "$start"
    ;;
*)
    release=$1
    shift
    if [ $# -gt 0 ]; then tryRelease "$release" "$@"; else tryRelease "$release" "$start" ./test.sh; fi
    ;;
esac
