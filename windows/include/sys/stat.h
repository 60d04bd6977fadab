#pragma once
// The state of a file by its name in UTF-16, and what the C library of Windows lacks.

#include_next <sys/stat.h>

#define S_ISSOCK(mode) 0

int stat(const wchar_t* file, struct stat* status);
/// Does nothing: files of Windows have no mode.
int fchmod(int descriptor, unsigned mode);
