#!/usr/bin/env bash
# Runs PROGRAM on a real OpenXR runtime (Monado), with a scripted head and two scripted controllers.
#
#   tests/xr/run_on_monado.sh PROGRAM [ARGUMENT...]      run PROGRAM with the runtime; exit with its status
#   tests/xr/run_on_monado.sh --display PROGRAM [ARG...] run PROGRAM with the X server but no runtime
#   tests/xr/run_on_monado.sh --prepare                  only fetch a runtime if there is none
#
# Uses the computer's monado-service if there is one. Otherwise it unpacks the packages of Debian 13 once into the user's
# cache, and runs their programs and PROGRAM with that tree's dynamic linker. That needs no chroot, mounts or privileges,
# so it works for root, for users and in containers. Libraries that the tree lacks come from the computer.
#
# PROGRAM sees: DISPLAY (an X server of its own, where the compositor shows both eyes), XR_RUNTIME_JSON and
#   MELTPOOL_XR_PORT   loopback TCP port of Monado's remote driver (tests/xr/remote_driver.hpp writes to it)
#   MELTPOOL_XR_BENCH  folder of this run: service.pid, service.log
#   MELTPOOL_XR_LAUNCH words before a command that PROGRAM starts
# Restarts the service MELTPOOL_XR_RESTART_DELAY seconds (2) after its death; a test may kill it.
# MELTPOOL_XR_KEEP is a folder for the logs. Exits with 77 if there is no runtime; with 1 if CI is set.
set -u

readonly suite=trixie
readonly tree_version=1 # raise it when the list below changes
readonly packages=monado-service,libopenxr1-monado,libopenxr-loader1,openxr-layer-corevalidation,libgl1-mesa-dri,mesa-vulkan-drivers,libegl1,libegl-mesa0,libglx-mesa0,libgl1,xkb-data
readonly cache=${MELTPOOL_XR_CACHE:-${XDG_CACHE_HOME:-${HOME:-/tmp}/.cache}/meltpool}
readonly tree=$cache/monado-$suite-$tree_version-$(uname -m)

say() { printf 'run_on_monado.sh: %s\n' "$*" >&2; }
noRuntime() {
    say "$*"
    [ -n "${CI:-}" ] && exit 1
    exit 77
}

# Unpacks the tree once; a second process waits for the first.
fetchTree() {
    [ -e "$tree/.complete" ] && return 0
    command -v mmdebstrap >/dev/null || noRuntime "no monado-service on this machine and no mmdebstrap to fetch one with"
    mkdir -p "$cache"
    exec 9>"$tree.lock"
    flock 9
    if [ ! -e "$tree/.complete" ]; then
        say "unpacking an OpenXR runtime (Monado, 700 MB) into $tree"
        rm -rf "$tree.part"
        mmdebstrap --quiet --mode=chrootless --skip=check/chrootless --variant=extract --include=$packages $suite "$tree.part" </dev/null >"$tree.log" 2>&1 ||
            { tail -n 5 "$tree.log" >&2; noRuntime "mmdebstrap could not unpack $suite"; }
        rm -rf "$tree"
        mv "$tree.part" "$tree" && : >"$tree/.complete"
    fi
    exec 9>&-
}

# Sets `launch` (the words before a command that uses the runtime) and the variables by which the runtime finds its parts.
findRuntime() {
    launch=()
    if [ -z "${MELTPOOL_XR_TREE:-}" ] && command -v monado-service >/dev/null; then
        service=$(command -v monado-service)
        export XR_RUNTIME_JSON=${XR_RUNTIME_JSON:-/usr/share/openxr/1/openxr_monado.json}
        return
    fi
    fetchTree
    local lib=$tree/usr/lib/$(uname -m)-linux-gnu path sub linker
    linker=$(echo "$lib"/ld-linux-*.so.*)
    path=$lib:$tree/usr/lib
    for sub in blas lapack pulseaudio; do path+=:$lib/$sub; done
    path+=:/usr/lib/$(uname -m)-linux-gnu:/usr/local/lib
    launch=("$linker" --library-path "$path")
    service=$tree/usr/bin/monado-service
    export XR_RUNTIME_JSON=$tree/usr/share/openxr/1/openxr_monado.json
    export VK_DRIVER_FILES=$tree/usr/share/vulkan/icd.d/lvp_icd.json VK_ICD_FILENAMES=$tree/usr/share/vulkan/icd.d/lvp_icd.json
    export __EGL_VENDOR_LIBRARY_DIRS=$tree/usr/share/glvnd/egl_vendor.d LIBGL_DRIVERS_PATH=$lib/dri
    # Rewrites the validation layer's manifest with its path in the tree.
    export XR_API_LAYER_PATH=$run/layers
    mkdir -p "$run/layers"
    sed "s#\"library_path\": *\"/#&${tree#/}/#" "$tree"/usr/share/openxr/1/api_layers/explicit.d/*core_validation*.json >"$run/layers/core_validation.json"
}

freePort() {
    local port
    while :; do
        port=$((20000 + RANDOM))
        (exec 3<>"/dev/tcp/127.0.0.1/$port") 2>/dev/null || break
    done
    echo "$port"
}

startDisplay() {
    command -v Xvfb >/dev/null || noRuntime "no Xvfb on this machine"
    local number
    # -noreset: a server that resets after its last client refuses clients meanwhile.
    setpriv --pdeathsig KILL Xvfb -displayfd 8 -screen 0 "${MELTPOOL_XR_SCREEN:-1280x720x24}" -noreset -nolisten tcp 8>"$run/display" >"$run/xvfb.log" 2>&1 </dev/null &
    display_pid=$!
    for _ in $(seq 3000); do
        read -r number <"$run/display" 2>/dev/null && [ -n "$number" ] && break
        sleep 0.1
    done
    [ -n "${number:-}" ] || { cat "$run/xvfb.log" >&2; noRuntime "Xvfb does not come up"; }
    export DISPLAY=:$number
    unset WAYLAND_DISPLAY XAUTHORITY
}

# Starts the service and waits for it, at most five minutes: a busy computer is slow.
startService() {
    : >"$run/service.log"
    # Removes the socket of a killed service: the next one would refuse to start.
    rm -f "$XDG_RUNTIME_DIR"/monado_comp_ipc "$XDG_RUNTIME_DIR"/monado.pid
    XRT_LOG=info setpriv --pdeathsig KILL ${launch[@]+"${launch[@]}"} "$service" </dev/null >>"$run/service.log" 2>&1 &
    service_pid=$!
    disown # no message of the shell when a test kills it
    echo "$service_pid" >"$run/service.pid"
    for _ in $(seq 3000); do
        grep -q 'service has started' "$run/service.log" && return 0
        kill -0 "$service_pid" 2>/dev/null || break
        sleep 0.1
    done
    tail -n 20 "$run/service.log" >&2
    # A failed restart is an error, not a missing runtime.
    [ -z "${program_pid:-}" ] && noRuntime "the OpenXR service does not come up"
    say "the OpenXR service does not come up again"
    exit 1
}

cleanUp() {
    local pid
    for pid in ${program_pid:-} ${service_pid:-} ${display_pid:-}; do kill "$pid" 2>/dev/null; done
    for _ in $(seq 20); do
        kill -0 ${program_pid:-} ${service_pid:-} ${display_pid:-} 2>/dev/null || break
        sleep 0.1
    done
    for pid in ${program_pid:-} ${service_pid:-} ${display_pid:-}; do kill -9 "$pid" 2>/dev/null; done
    wait 2>/dev/null
    [ -n "${MELTPOOL_XR_KEEP:-}" ] && cp -f "$run"/*.log "$run"/*.txt "$MELTPOOL_XR_KEEP" 2>/dev/null
    rm -rf "$run"
}

[ $# -ge 1 ] || { say "usage: run_on_monado.sh [--display] PROGRAM [ARGUMENT...] | --prepare"; exit 2; }
run=$(mktemp -d "${TMPDIR:-/tmp}/meltpool-xr.XXXXXX")
trap cleanUp EXIT
trap 'exit 129' HUP
trap 'exit 130' INT
trap 'exit 143' TERM
if [ "$1" = --display ]; then
    shift
    startDisplay
    "$@" </dev/null
    exit
fi
findRuntime
[ "$1" = --prepare ] && exit 0

export XDG_RUNTIME_DIR=$run/runtime XDG_CONFIG_HOME=$run/config XDG_DATA_HOME=$run/data
mkdir -m 700 "$XDG_RUNTIME_DIR"
mkdir -p "$XDG_CONFIG_HOME/monado"
MELTPOOL_XR_PORT=$(freePort)
export MELTPOOL_XR_PORT MELTPOOL_XR_BENCH=$run
# One word a line, for programs that PROGRAM starts.
MELTPOOL_XR_LAUNCH=$(printf '%s\n' ${launch[@]+"${launch[@]}"})
export MELTPOOL_XR_LAUNCH
echo "{\"active\": \"remote\", \"remote\": {\"version\": 0, \"port\": $MELTPOOL_XR_PORT, \"view_count\": 2}}" >"$XDG_CONFIG_HOME/monado/config_v0.json"
export XRT_NO_STDIN=1 P_OVERRIDE_ACTIVE_CONFIG=remote XRT_COMPOSITOR_FORCE_XCB=1
export XRT_COMPOSITOR_SCALE_PERCENTAGE=${XRT_COMPOSITOR_SCALE_PERCENTAGE:-70}
startDisplay
startService
# Names the program's files: with the tree's linker the program does not know its own path.
data=$(dirname "$(readlink -f "$1")")/../share/meltpool
[ -d "$data" ] && export MELTPOOL_DATA=${MELTPOOL_DATA:-$data}
# The runtime's library prints much to standard error; shown only if the program fails.
setpriv --pdeathsig TERM ${launch[@]+"${launch[@]}"} "$@" </dev/null 2>"$run/stderr.log" &
program_pid=$!
while kill -0 "$program_pid" 2>/dev/null; do
    if ! kill -0 "$service_pid" 2>/dev/null; then
        sleep "${MELTPOOL_XR_RESTART_DELAY:-2}"
        startService
    fi
    sleep 0.1
done
wait "$program_pid"
status=$?
program_pid=
if [ "$status" -ne 0 ]; then
    grep -v 'XR_ERROR_FUNCTION_UNSUPPORTED' "$run/stderr.log" | tail -n 20 >&2
    say "the runtime's last words:"
    tail -n 10 "$run/service.log" >&2
fi
exit "$status"
