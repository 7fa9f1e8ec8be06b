# Sourced by fresh_machine and bare_machine: minimal Debian systems in folders of their own, and steps in them that are
# timed. The sourcing script sets `inside`, the folder in which commands run there. Needs root.

say() { echo "$(basename "$0"): $*" >&2; }
give_up() { say "$*"; exit 2; }

# Sets release, cache and mirror from the options that all such scripts take.
read_options() {
  release=$(own_release) cache= mirror=
  while (($#)); do
    case $1 in
      bookworm | trixie) release=$1; shift ;;
      --cache) cache=$(realpath --canonicalize-missing "${2:?--cache needs a folder}"); shift 2 ;;
      --mirror) mirror=${2:?--mirror needs an address}; shift 2 ;;
      *) give_up "not understood: $1; expected [bookworm|trixie] [--mirror URL] [--cache FOLDER]" ;;
    esac
  done
  mirror=${mirror:-$(own_mirror)}
  [[ $(id -u) == 0 ]] || give_up "debootstrap and chroot need root"
  command -v debootstrap >/dev/null || give_up "debootstrap is missing: apt-get install debootstrap debian-archive-keyring"
}

# A new system in the folder `system`, which is removed when the script ends, unless a step fails.
new_system() {
  system=$(mktemp -d "${TMPDIR:-/tmp}/$1_$release.XXXXXX")
  chmod 755 "$system"  # apt runs as another user, who must be able to read
  trap remove_system EXIT
  step "base system of $release" base_system "$release" "$mirror" "$cache"
  reach_the_network
}

own_release() { (. /etc/os-release && echo "${VERSION_CODENAME:-}"); }

# Output of the command goes to stderr, the times to stdout.
step() {
  local name=$1 begin=$SECONDS
  shift
  "$@" >&2 || { printf '%6d s  %s: FAILED\n' $((SECONDS - begin)) "$name"; leave_system; exit 1; }
  printf '%6d s  %s\n' $((SECONDS - begin)) "$name"
}

# The mirror of this machine's own Debian.
own_mirror() {
  apt-get indextargets --no-release-info --format '$(RELEASE) $(REPO_URI)' |
    awk -v own="$(own_release)" '$1 == own {print $2; exit}'
}

base_system() {
  local release=$1 mirror=$2 cache=$3 kept=
  [[ -n $mirror ]] || give_up "apt knows no mirror of this machine's own release: name one with --mirror"
  [[ -z $cache ]] || kept=$cache/$release.tar
  if [[ -n $kept && -f $kept ]]; then
    tar --extract --numeric-owner --file "$kept" --directory "$system"
    return
  fi
  # Without the archive's keys debootstrap would accept any package from any source.
  local keys=/usr/share/keyrings/debian-archive-keyring.gpg
  [[ -f $keys ]] || give_up "the archive's keys are missing: apt-get install debian-archive-keyring"
  debootstrap --variant=minbase --keyring="$keys" "$release" "$system" "$mirror" || return
  [[ -n $kept ]] || return 0
  mkdir -p "$cache" && tar --create --numeric-owner --file "$kept.new" --directory "$system" . && mv "$kept.new" "$kept"
}

# Copies this machine's network settings.
reach_the_network() {
  cp /etc/resolv.conf "$system/etc/resolv.conf"
  apt-config dump | grep -E '^Acquire::(http|https|Check-|Retries)' >"$system/etc/apt/apt.conf.d/90of-this-machine" || true
}

# Mounts and processes are in namespaces of their own, so they end with the command, whatever ends it.
in_system() {
  local proxies
  readarray -t proxies < <(env | grep -iE '^(http|https|no)_proxy=' || true)
  unshare --mount --pid --fork --kill-child bash -c '
    set -e
    mount -t proc proc "$1/proc"
    mkdir -p "$1/dev/pts" && mount -t devpts -o newinstance,ptmxmode=0666 devpts "$1/dev/pts"
    exec chroot "$1" bash -c "cd \"\$0\" && exec \"\$@\"" "$2" "${@:3}"' \
    bash "$system" "$inside" env -i HOME=/root PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin \
    "${proxies[@]}" "$@"
}

leave_system() {
  trap - EXIT
  say "left for a look: chroot $system (see $inside); then: rm -rf --one-file-system $system"
}

# debootstrap mounts too, and may be interrupted. If anything is still mounted, nothing is deleted.
remove_system() {
  local mounted
  while read -r mounted; do umount "$mounted" || true; done < <(mounts_below | sort --reverse)
  if [[ -n $(mounts_below) ]]; then
    say "still mounted, so not deleted: $(mounts_below | tr '\n' ' ')"
  else
    rm -rf --one-file-system "$system"
  fi
}

mounts_below() { awk -v root="$system/" 'index($5 "/", root) == 1 {print $5}' /proc/self/mountinfo; }
