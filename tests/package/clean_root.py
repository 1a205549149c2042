# SPDX-License-Identifier: GPL-3.0-or-later
"""Commands in a fresh copy of the running system that vanishes afterwards: an overlay over /, in memory. Root only."""

import os
import subprocess

SCRIPT = """
overlay=$1 source=$2 commands=$3
# No mount may be seen outside. In a chroot / is no mount, and scripts/in_root has seen to it.
mount --make-rprivate / 2>/dev/null || true
mount -t tmpfs tmpfs "$overlay"
mkdir "$overlay/upper" "$overlay/work" "$overlay/root"
root=$overlay/root
mount -t overlay overlay -o "lowerdir=/,upperdir=$overlay/upper,workdir=$overlay/work" "$root"
mount --rbind /dev "$root/dev"
mount -t proc proc "$root/proc"
mount -t tmpfs -o mode=1777 tmpfs "$root/tmp"
mkdir -p "$root$source"  # after /tmp, where it may lie
mount --bind "$source" "$root$source"
chroot "$root" bash -euc "$commands"
"""


def is_possible():
    return os.geteuid() == 0


def run(commands, source, folder):
    """Status and output of shell commands; they see `source` as it is outside, and what they write elsewhere is gone
    afterwards. `folder` is an empty one to work in."""
    folder.mkdir(exist_ok=True)
    done = subprocess.run(["unshare", "--mount", "--propagation", "unchanged", "bash", "-euc", SCRIPT, "clean_root", folder,
                           source, commands], check=False, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          errors="replace", timeout=300,
                          env={"PATH": "/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin", "HOME": "/tmp",
                               "LC_ALL": "C.UTF-8", "DEBIAN_FRONTEND": "noninteractive", "QT_QPA_PLATFORM": "offscreen"
                               if "apply_mlx" in commands else "xcb"})
    return done.returncode, done.stdout
