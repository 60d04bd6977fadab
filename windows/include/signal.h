#pragma once
// The signals of POSIX that end a program, by those of Windows: Ctrl-C is SIGINT, Ctrl-Break and a closed
// window are SIGHUP.

#include <pthread.h>
#include_next <signal.h>
#undef pthread_sigmask

#define SIGHUP SIGBREAK
#define SA_RESTART 0
#define SA_RESETHAND 0
#define SIG_BLOCK 0
#define SIG_SETMASK 2

using sigset_t = bool;  // whether Ctrl-C and Ctrl-Break are held back

struct sigaction {
  void (*sa_handler)(int);
  int sa_flags;
};

/// Handlers are called once.
int sigaction(int signal, const struct sigaction* action, struct sigaction* before);
int sigemptyset(sigset_t* signals);
int sigaddset(sigset_t* signals, int signal);
int pthread_sigmask(int how, const sigset_t* signals, sigset_t* before);
