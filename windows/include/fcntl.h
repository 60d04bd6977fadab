#pragma once
// Opening files: what the C library of Windows lacks, and names in UTF-16, as std::filesystem keeps them.

#include_next <fcntl.h>
#include <io.h>

#define O_CLOEXEC _O_NOINHERIT
#define O_NONBLOCK 0
#define O_NOCTTY 0
#define O_DIRECTORY 0
#define AT_FDCWD (-100)
#define RENAME_NOREPLACE 1

/// Bytes as they are, without line ends of Windows. A folder is refused with EISDIR.
int open(const wchar_t* file, int flags, int mode = 0);

/// Renames without replacing. The folders are unused, and there is no other flag.
int renameat2(int folder, const wchar_t* from, int other_folder, const wchar_t* to, unsigned flags);
/// Renames, replacing a file.
int rename(const wchar_t* from, const wchar_t* to);
