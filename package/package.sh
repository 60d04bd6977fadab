# shellcheck shell=bash disable=SC2154
# Functions of ./do package: a Debian package, an archive for any Linux, and the sources. $root, $version,
# $packages (the folder for the results) and $stage (what cmake --install installed) are set by ./do.

# Libraries of headers only: they are in the program, and so their licenses have to be with it.
header_libraries=(libboost1.74-dev libcli11-dev libeigen3-dev libhwy-dev
  librandom123-dev libtomlplusplus-dev nlohmann-json3-dev)

# What every package has: the command with its parts, the library for C, the data, pages and completions. The
# static libraries of C++ are left to those who build, as they fit one compiler.
stage_files() {
  rm -rf "$stage"
  logged env -u DESTDIR cmake --install "$root/build/release" --prefix "$stage" --strip
  rm -rf "$stage"/lib/*.a "$stage/lib/cmake" "$stage/include/dashpad"
}

# copy_licenses FOLDER PACKAGE...
copy_licenses() {
  local folder="$1" package
  shift
  mkdir -p "$folder"
  for package in "$@"; do cp "/usr/share/doc/$package/copyright" "$folder/$package"; done
}

# The lines Depends, Recommends and Suggests of these programs and libraries; what stands in one is left out of
# the next.
dependencies() {
  (cd "$packages/deb" && dpkg-shlibdeps -O --warnings=0 "$@") | sed -n 's/^shlibs:\([^=]*\)=/\1: /p'
}

make_deb() {
  local tree="$packages/deb/dashpad" doc file parts
  rm -rf "$packages/deb"
  mkdir -p "$tree/DEBIAN" "$packages/deb/debian" "$tree/usr"
  doc="$tree/usr/share/doc/dashpad"
  printf 'Source: dashpad\n\nPackage: dashpad\nArchitecture: any\n' >"$packages/deb/debian/control"
  cp -R "$stage/." "$tree/usr"
  mkdir -p "$tree/usr/lib/x86_64-linux-gnu" "$tree/usr/share/lintian/overrides" "$doc"
  mv "$tree"/usr/lib/libdashpad.so* "$tree/usr/lib/x86_64-linux-gnu"
  cp "$root/package/lintian-overrides" "$tree/usr/share/lintian/overrides/dashpad"
  cp "$root/package/copyright" "$doc/copyright"
  copy_licenses "$doc/licenses" "${header_libraries[@]}"
  gzip -9nc "$root/CHANGELOG.md" >"$doc/changelog.gz"
  printf 'dashpad (%s-1) unstable; urgency=medium\n\n  * The changes are in changelog.gz.\n\n -- %s  %s\n' \
    "$version" "$maintainer" "$(date --utc -R -d "@$SOURCE_DATE_EPOCH")" | gzip -9nc >"$doc/changelog.Debian.gz"
  gzip -9n "$tree"/usr/share/man/man1/*.1
  ln -s dashpad-study.1.gz "$tree/usr/share/man/man1/dashpad-mpi.1.gz"
  parts=("$tree"/usr/lib/dashpad/*.so)
  cat >"$tree/DEBIAN/control" <<TEXT
Package: dashpad
Version: $version-1
Architecture: amd64
Maintainer: $maintainer
Section: science
Priority: optional
Installed-Size: $(du -sk "$tree/usr" | cut -f1)
$(dependencies -dDepends -e"$tree/usr/bin/dashpad" -e"$(echo "$tree"/usr/lib/x86_64-linux-gnu/libdashpad.so.*.*)" \
    -dRecommends "${parts[@]/#/-e}" -dSuggests -e"$tree/usr/bin/dashpad-mpi")
Description: impact of a rigid nose on a foam pad
 Dashpad computes force, acceleration, penetration and rebound of an impact on
 a foam pad, the head injury criterion and the verdict of a standard, with
 intervals for what is not known of foam and model. Foams and standards come
 with it.
 .
 The recommended packages serve PNG and PDF pictures, archives of ISO-MME tests
 and HDF5 files; the suggested one serves studies on several machines.
TEXT
  echo "libdashpad 1 dashpad (>= $version)" >"$tree/DEBIAN/shlibs"
  echo "activate-noawait ldconfig" >"$tree/DEBIAN/triggers"
  (cd "$tree" && find usr -type f -print0 | sort -z | xargs -0 md5sum >DEBIAN/md5sums)
  chmod -R u=rwX,go=rX "$tree"
  file="$packages/dashpad_$version-1_amd64.deb"
  logged dpkg-deb --root-owner-group -Zxz --build "$tree" "$file"
  lintian --info --fail-on error "$file" >"$packages/lintian.txt" 2>&1 ||
    { cat "$packages/lintian.txt" >&2 && return 1; }
  grep '^[EW]:' "$packages/lintian.txt" >&2 || true
}

# Every library that these need, but for those of glibc, which fit the system's dynamic linker only.
bundled_libraries() {
  ldd "$@" | sed -n 's/.* => \(\/[^ ]*\) .*/\1/p' | sort -u |
    grep -vE '/lib(c|m|dl|pthread|rt|resolv|util|anl|nsl|libdashpad)\.so|/ld-linux'
}

# The Debian packages of files, which dpkg knows with or without /usr and by the name that links lead to.
packages_of_files() {
  local file paths=()
  for file in "$@"; do
    file="$(readlink -f "$file")"
    paths+=("$file" "${file#/usr}")
  done
  dpkg-query --search "${paths[@]}" 2>/dev/null | sed 's/:.*//' | sort -u
}

make_archive() {
  local name="dashpad-$version-linux-x86_64" tree bundled minor libraries origins
  tree="$packages/$name"
  bundled="$tree/lib/dashpad/bundled"
  rm -rf "$tree"
  cp -R "$stage" "$tree"
  rm -f "$tree/bin/dashpad-mpi"  # MPI belongs to the machine
  mkdir -p "$tree/libexec" "$bundled" "$tree/share/doc/dashpad"
  mv "$tree/bin/dashpad" "$tree/libexec/dashpad"
  cp "$root/LICENSE" "$root/CHANGELOG.md" "$root/docs/packages.md" "$tree/share/doc/dashpad"
  mapfile -t libraries < <(
    bundled_libraries "$tree/libexec/dashpad" "$tree"/lib/dashpad/*.so "$tree"/lib/libdashpad.so.*.*)
  cp -L "${libraries[@]}" "$bundled"
  mapfile -t origins < <(packages_of_files "${libraries[@]}")
  copy_licenses "$tree/share/doc/dashpad/licenses" "${origins[@]}" "${header_libraries[@]}"
  # As RPATH, not RUNPATH, it also counts for what the bundled libraries need, and for parts that are loaded later.
  patchelf --force-rpath --set-rpath "\$ORIGIN/../lib/dashpad/bundled" "$tree/libexec/dashpad"
  patchelf --force-rpath --set-rpath "\$ORIGIN/dashpad/bundled" "$tree"/lib/libdashpad.so.*.*
  minor="$(find "$tree/lib" "$tree/libexec" -type f -exec objdump -T {} + |
    sed -n 's/.*GLIBC_2\.\([0-9]*\)[). ].*/\1/p' | sort -n | tail -n 1)"
  logged cc -O2 -Wall -Wextra -fno-stack-protector -nostartfiles -s "-DGLIBC_MINOR=$minor" -o "$tree/bin/dashpad" \
    "$root/package/start.c"
  chmod -R u=rwX,go=rX "$tree"
  tar --create --sort=name --mtime="@$SOURCE_DATE_EPOCH" --owner=0 --group=0 --numeric-owner \
    --directory "$packages" "$name" |
    xz -6 -T "$jobs" >"$packages/$name.tar.xz"
  say "The archive needs glibc 2.$minor or newer."
}

# With the commit in a file, which version.cpp takes where no git is.
make_sources() {
  git -C "$root" archive --format=tar --prefix="dashpad-$version/" \
    --add-virtual-file="dashpad-$version/COMMIT:$(git -C "$root" rev-parse --short=12 HEAD)" HEAD |
    xz -6 -T "$jobs" >"$packages/dashpad-$version.tar.xz"
}

# --- Trials in systems that have nothing else ---

# fresh_root SUITE: $trial is a minimal Debian, made once and copied. Fails if it cannot be made.
fresh_root() {
  local kept="$packages/roots/$1"
  if [[ ! -e "$kept.made" ]]; then
    rm -rf "$kept"
    debootstrap --variant=minbase "$1" "$kept" >"$packages/debootstrap.txt" 2>&1 || return 1
    touch "$kept.made"
  fi
  end_trial &&
    cp -a "$kept" "$trial" &&
    mount --bind /proc "$trial/proc" &&
    cp "$root/package/try.sh" "$trial/usr/local/bin"
}

end_trial() {
  if mountpoint -q "$trial/proc"; then umount "$trial/proc"; fi
  rm -rf --one-file-system "$trial"
}

inside() {
  env -i PATH=/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin DEBIAN_FRONTEND=noninteractive chroot "$trial" "$@"
}

# The trials are chains of &&: where the caller looks at the outcome, bash does not stop at a failure by itself.

# The Debian package in Debian 12: first with what it depends on alone, then with what it recommends.
try_deb() {
  local log="$packages/apt.txt"
  cp "$packages/dashpad_$version-1_amd64.deb" "$trial/tmp" &&
    inside apt-get update >"$log" 2>&1 &&
    inside apt-get install --yes --no-install-recommends "/tmp/dashpad_$version-1_amd64.deb" >>"$log" 2>&1 &&
    inside dashpad run /usr/share/dashpad/examples/dashboard-20mph.toml >"$packages/trial.txt" &&
    inside apt-get install --yes --fix-policy --install-recommends dashpad >>"$log" 2>&1 &&
    inside try.sh dashpad /usr/share/dashpad &&
    inside apt-get remove --yes dashpad >>"$log" 2>&1
}

unpack_archive() {
  tar --extract --xz --file "$packages/dashpad-$version-linux-x86_64.tar.xz" --directory "$trial/opt"
}

# The archive, under a link and with nothing installed.
try_archive() {
  local folder="/opt/dashpad-$version-linux-x86_64"
  unpack_archive &&
    ln -s "$folder/bin/dashpad" "$trial/usr/local/bin/dashpad" &&
    inside try.sh /usr/local/bin/dashpad "$folder/share/dashpad"
}

# On a system that is too old it says so in one sentence.
try_refusal() {
  local said status=0
  unpack_archive || return
  said="$(inside "/opt/dashpad-$version-linux-x86_64/bin/dashpad" --version 2>&1)" || status=$?
  say "  $said"
  [[ $status -eq 1 && "$said" == "dashpad: this archive needs glibc "* && "$(wc -l <<<"$said")" -eq 1 ]]
}

try_packages() {
  local suite kind
  if [[ "$(id -u)" -ne 0 ]]; then
    say "Not tried in clean systems: that needs root."
    return
  fi
  trial="$packages/roots/trial"  # not local: the trap has to see it
  trap end_trial EXIT
  for suite in bookworm:deb trixie:archive bullseye:refusal; do
    kind="${suite#*:}" suite="${suite%:*}"
    if ! fresh_root "$suite"; then
      say "Not tried in $suite: there is no network for debootstrap, or no right to mount /proc."
      continue
    fi
    say "In a minimal $suite ($kind):"
    "try_$kind" || fail "$kind does not work in $suite"
  done
  end_trial
  trap - EXIT
}
