#pragma once
// Files by names in UTF-16, and what the C library of Windows lacks.

#include <sys/types.h>
#include_next <unistd.h>

#include <cstddef>

#undef W_OK
#undef X_OK
#define W_OK 2
#define X_OK 0

/// Whether files can be created in a folder, by trying: rights of Windows are no mode.
int access(const wchar_t* folder, int mode);
int link(const wchar_t* from, const wchar_t* to);
int unlink(const wchar_t* file);
int fsync(int descriptor);

// Sizes of more than 32 bits, of which at most 1 GiB is read or written at once.
ssize_t read(int descriptor, void* bytes, std::size_t size);
ssize_t write(int descriptor, const void* bytes, std::size_t size);
