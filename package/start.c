/* bin/dashpad of the archive for any Linux: starts libexec/dashpad, unless the C library of this system is too old
   for it. Then the dynamic linker would print a line for each symbol that it misses. This program needs nothing of
   glibc that is newer than 2.2.5: hence no start files of the compiler, which need 2.34. */
#define _GNU_SOURCE
#include <gnu/libc-version.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define TEXT(value) #value
#define TEXT_OF(macro) TEXT(macro)
static const char program[] = "/../libexec/dashpad";

__asm__(".globl _start\n"
        "_start: xor %ebp, %ebp\n"
        "mov %rsp, %rdi\n"
        "and $-16, %rsp\n"
        "call begin\n");

/* Never returns. At `stack` the kernel leaves the number of arguments, the arguments, and the environment. */
void begin(long *stack) {
  char **arguments = (char **)(stack + 1), **environment = arguments + *stack + 1;
  const char *version = gnu_get_libc_version(), *minor = strchr(version, '.');
  if (version[0] == '2' && minor && strtol(minor + 1, NULL, 10) < GLIBC_MINOR) {
    dprintf(STDERR_FILENO,
            "dashpad: this archive needs glibc 2." TEXT_OF(GLIBC_MINOR) " or newer, as in Debian 12, Ubuntu 24.04, "
            "Fedora 37 or RHEL 10, and this system has %s\n",
            version);
    _exit(1);
  }
  char path[PATH_MAX];
  const ssize_t size = readlink("/proc/self/exe", path, sizeof path - sizeof program);
  char *end = size > 0 ? memrchr(path, '/', (size_t)size) : NULL;
  if (end) {
    memcpy(end, program, sizeof program);
    execve(path, arguments, environment);
  }
  perror("dashpad: cannot start libexec/dashpad");
  _exit(1);
}
