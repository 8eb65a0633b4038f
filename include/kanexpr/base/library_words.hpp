#pragma once

#include <cstddef>
#include <string_view>

/// Names that generated C functions and variables should avoid, separated by spaces.
namespace kanexpr::base::library_words {

/// The functions of math.h, including C23 and common extensions; each has variants for other types, such as
/// sinf.
inline constexpr std::string_view functions_of_mathematics = R"(
acos asin atan atan2 cos sin tan acosh asinh atanh cosh sinh tanh exp exp2 expm1 frexp ilogb ldexp log log10
log1p log2 logb modf scalbn scalbln cbrt fabs hypot pow sqrt erf erfc lgamma tgamma ceil floor nearbyint
rint lrint llrint round lround llround trunc fmod remainder remquo copysign nan nextafter nexttoward fdim
fmax fmin fma j0 j1 jn y0 y1 yn gamma signgam sincos drem significand scalb finite isnan isinf exp10 pow10
roundeven canonicalize fmaximum fminimum fmaximum_num fminimum_num fmaximum_mag fminimum_mag
fmaximum_mag_num fminimum_mag_num fmaxmag fminmag fromfp fromfpx ufromfp ufromfpx llogb nextup nextdown
getpayload setpayload setpayloadsig totalorder totalordermag fadd fsub fmul fdiv ffma fsqrt dadd dsub dmul
ddiv dfma dsqrt acospi asinpi atanpi atan2pi cospi sinpi tanpi exp10m1 exp2m1 log10p1 log2p1 logp1 rsqrt
rootn compoundn powr pown
)";

/// The other names in math.h.
inline constexpr std::string_view other_words_of_mathematics = R"(
INFINITY NAN SNAN SNANF SNANL HUGE HUGE_VAL HUGE_VALF HUGE_VALL MAXFLOAT NULL FP_NAN FP_ZERO FP_NORMAL
FP_INFINITE FP_SUBNORMAL FP_ILOGB0 FP_ILOGBNAN FP_LLOGB0 FP_LLOGBNAN FP_FAST_FMA FP_FAST_FMAF FP_FAST_FMAL
FP_INT_UPWARD FP_INT_DOWNWARD FP_INT_TOWARDZERO FP_INT_TONEAREST FP_INT_TONEARESTFROMZERO MATH_ERRNO
MATH_ERREXCEPT math_errhandling M_E M_LOG2E M_LOG10E M_LN2 M_LN10 M_PI M_PI_2 M_PI_4 M_1_PI M_2_PI
M_2_SQRTPI M_SQRT2 M_SQRT1_2 DOMAIN SING OVERFLOW UNDERFLOW PLOSS TLOSS X_TLOSS isfinite isnormal signbit
fpclassify isgreater isgreaterequal isless islessequal islessgreater isunordered iscanonical iseqsig
issignaling issubnormal iszero double_t float_t lgamma_r lgammaf_r lgammal_r
)";

/// Macros in the other C headers that expand to values; they are replaced wherever they appear.
inline constexpr std::string_view macros_of_the_library = R"(
errno stdin stdout stderr EOF WEOF NULL BUFSIZ FILENAME_MAX FOPEN_MAX L_tmpnam TMP_MAX SEEK_CUR SEEK_END
SEEK_SET EXIT_FAILURE EXIT_SUCCESS RAND_MAX MB_CUR_MAX MB_LEN_MAX CLOCKS_PER_SEC TIME_UTC CHAR_BIT CHAR_MAX
CHAR_MIN SCHAR_MAX SCHAR_MIN UCHAR_MAX SHRT_MAX SHRT_MIN USHRT_MAX INT_MAX INT_MIN UINT_MAX LONG_MAX
LONG_MIN ULONG_MAX LLONG_MAX LLONG_MIN ULLONG_MAX SIZE_MAX PTRDIFF_MAX PTRDIFF_MIN INTMAX_MAX INTMAX_MIN
UINTMAX_MAX FLT_RADIX FLT_ROUNDS FLT_EPSILON FLT_MAX FLT_MIN FLT_DIG FLT_MANT_DIG FLT_MAX_EXP FLT_MIN_EXP
DBL_EPSILON DBL_MAX DBL_MIN DBL_DIG DBL_MANT_DIG DBL_MAX_EXP DBL_MIN_EXP LDBL_EPSILON LDBL_MAX LDBL_MIN
LDBL_DIG DECIMAL_DIG FLT_EVAL_METHOD EDOM ERANGE EILSEQ LC_ALL LC_COLLATE LC_CTYPE LC_MONETARY LC_NUMERIC
LC_TIME SIGABRT SIGFPE SIGILL SIGINT SIGSEGV SIGTERM SIG_DFL SIG_ERR SIG_IGN
)";

/// The other names in the C and POSIX libraries. The compiler may mistake a function with such a name for the
/// library function, or the function may replace the library function in the program.
inline constexpr std::string_view words_of_the_library = R"(
EOF FILE I a64l abort abs accept access alarm aligned_alloc alloca alphasort asctime assert at_quick_exit
atexit atof atoi atol atoll basename bcmp bcopy bind bsearch btowc bzero cabs cabsf cabsl cacos cacosf
cacosh cacoshf cacoshl cacosl calloc carg cargf cargl casin casinf casinh casinhf casinhl casinl catan
catanf catanh catanhf catanhl catanl catclose catgets catopen ccos ccosf ccosh ccoshf ccoshl ccosl cexp
cexpf cexpl cfgetispeed cfgetospeed cfsetispeed cfsetospeed chdir chmod chown cimag cimagf cimagl clearerr
clock clock_t clog clog10 clog10f clog10l clogf clogl close closedir closelog complex confstr conj conjf
conjl connect cpow cpowf cpowl cproj cprojf cprojl creal crealf creall creat csin csinf csinh csinhf csinhl
csinl csqrt csqrtf csqrtl ctan ctanf ctanh ctanhf ctanhl ctanl ctermid ctime daylight dcgettext dgettext
difftime dirfd dirname div div_t dlclose dlerror dlopen dlsym dprintf drand48 dup dup2 duplocale endgrent
endhostent endnetent endprotoent endpwent endservent environ erand48 errno execl execle execlp execv execve
execvp exit faccessat fchdir fchmod fchmodat fchown fchownat fclose fcntl fdatasync fdopen fdopendir
feclearexcept fegetenv fegetexceptflag fegetround feholdexcept fenv_t feof feraiseexcept ferror fesetenv
fesetexceptflag fesetround fetestexcept feupdateenv fexcept_t fexecve fflush ffs ffsl ffsll fgetc fgetpos
fgets fgetwc fgetws fileno flock flockfile fmemopen fnmatch fopen fork fpathconf fpos_t fprintf fputc
fputc_unlocked fputs fputs_unlocked fputwc fputws fread free freeaddrinfo freelocale freopen fscanf fseek
fseeko fsetpos fstat fstatat fstatvfs fsync ftell ftello ftok ftruncate ftrylockfile ftw funlockfile
futimens fwide fwprintf fwrite fwrite_unlocked fwscanf getaddrinfo getc getchar getcwd getdate getdelim
getegid getenv geteuid getgid getgrent getgrgid getgrnam getgroups gethostbyaddr gethostbyname gethostent
gethostid gethostname getitimer getline getlogin getnameinfo getnetbyaddr getnetbyname getnetent getopt
getpeername getpgid getpgrp getpid getppid getpriority getprotobyname getprotobynumber getprotoent getpwent
getpwnam getpwuid getrlimit getrusage gets getservbyname getservbyport getservent getsid getsockname
getsockopt getsubopt gettext gettimeofday getuid getwc getwchar glob globfree gmtime grantpt hcreate
hdestroy hsearch htonl htons iconv imaginary imaxabs imaxdiv imaxdiv_t index initstate insque int16_t
int32_t int64_t int8_t intmax_t intptr_t isalnum isalpha isascii isatty isblank iscntrl isdigit isgraph
islower isprint ispunct isspace isupper iswalnum iswalpha iswblank iswcntrl iswctype iswdigit iswgraph
iswlower iswprint iswpunct iswspace iswupper iswxdigit isxdigit jmp_buf jrand48 kill killpg l64a labs lchown
lcong48 ldiv ldiv_t lfind link linkat listen llabs lldiv lldiv_t localeconv localtime lockf longjmp lrand48
lsearch lseek lstat main malloc max_align_t mblen mbrlen mbrtowc mbsinit mbsnrtowcs mbsrtowcs mbstate_t
mbstowcs mbtowc memalign memccpy memchr memcmp memcpy memmove mempcpy memset mkdir mkdirat mkdtemp mkfifo
mkfifoat mknod mknodat mkstemp mktime mlock mlockall mmap mprotect mrand48 msgctl msgget msgrcv msgsnd msync
munlock munlockall munmap nanosleep newlocale nftw nice nrand48 ntohl ntohs offsetof open openat opendir
openlog optarg opterr optind optopt pathconf pause pclose perror pipe poll popen posix_memalign pread printf
pselect psiginfo psignal ptrdiff_t ptsname putc putc_unlocked putchar putchar_unlocked putenv puts putwc
putwchar pwrite qsort quick_exit raise rand random read readdir readlink readlinkat readv realloc realpath
recv recvfrom recvmsg regcomp regerror regexec regfree remove remque rename renameat rewind rewinddir rindex
rmdir scandir scanf seed48 seekdir select semctl semget semop send sendmsg sendto setbuf setegid setenv
seteuid setgid setgrent sethostent setitimer setjmp setlocale setlogmask setnetent setpgid setpgrp
setpriority setprotoent setpwent setregid setreuid setrlimit setservent setsid setsockopt setstate setuid
setvbuf shmat shmctl shmdt shmget shutdown sig_atomic_t sigaction sigaddset sigaltstack sigdelset
sigemptyset sigfillset sighold sigignore siginterrupt sigismember sigjmp_buf siglongjmp signal sigpause
sigpending sigprocmask sigqueue sigrelse sigset sigsetjmp sigsuspend sigtimedwait sigwait sigwaitinfo size_t
sleep snprintf sockatmark socket socketpair sprintf srand srand48 srandom sscanf stat statvfs stderr stdin
stdout stpcpy stpncpy strcasecmp strcat strchr strcmp strcoll strcpy strcspn strdup strerror strfmon
strftime strlen strncasecmp strncat strncmp strncpy strndup strnlen strpbrk strptime strrchr strsignal
strspn strstr strtod strtof strtoimax strtok strtol strtold strtoll strtoul strtoull strtoumax strxfrm swab
swprintf swscanf symlink symlinkat sync sysconf syslog system tcdrain tcflow tcflush tcgetattr tcgetpgrp
tcgetsid tcsendbreak tcsetattr tcsetpgrp tdelete telldir tempnam tfind time time_t times timezone tmpfile
tmpnam toascii tolower toupper towctrans towlower towupper truncate tsearch ttyname twalk tzname tzset
uint16_t uint32_t uint64_t uint8_t uintmax_t uintptr_t umask uname ungetc ungetwc unlink unlinkat unlockpt
unsetenv uselocale utime utimensat utimes va_arg va_copy va_end va_list va_start vdprintf vfork vfprintf
vfscanf vfwprintf vfwscanf vprintf vscanf vsnprintf vsprintf vsscanf vswprintf vswscanf vwprintf vwscanf
wait waitid waitpid wchar_t wcpcpy wcpncpy wcrtomb wcscasecmp wcscat wcschr wcscmp wcscoll wcscpy wcscspn
wcsdup wcsftime wcslen wcsncasecmp wcsncat wcsncmp wcsncpy wcsnlen wcsnrtombs wcspbrk wcsrchr wcsrtombs
wcsspn wcsstr wcstod wcstof wcstoimax wcstok wcstol wcstold wcstoll wcstombs wcstoul wcstoull wcstoumax
wcswcs wcswidth wcsxfrm wctob wctomb wctrans wctrans_t wctype wctype_t wcwidth wint_t wmemchr wmemcmp
wmemcpy wmemmove wmemset wordexp wordfree wprintf write writev wscanf
)";

/// The suffixes of the variants of a math.h function for other types.
inline constexpr std::string_view ends_of_functions[]{"",     "f",   "l",    "f16", "f32",
                                                      "f32x", "f64", "f64x", "f128"};

/// Removes and returns the next word of a list; returns an empty word at the end of the list.
constexpr std::string_view next_of(std::string_view& words) {
  constexpr std::string_view spaces = " \n";
  const std::size_t begin = words.find_first_not_of(spaces);
  if (begin == words.npos) return words = {};
  words.remove_prefix(begin);
  const std::string_view word = words.substr(0, words.find_first_of(spaces));
  words.remove_prefix(word.size());
  return word;
}

/// Whether a C header may define the name.
constexpr bool has(std::string_view name) {
  const auto holds = [](std::string_view words, std::string_view wanted) {
    for (std::string_view word = next_of(words); !word.empty(); word = next_of(words))
      if (word == wanted) return true;
    return false;
  };
  for (const std::string_view end : ends_of_functions)
    if (name.ends_with(end) && holds(functions_of_mathematics, name.substr(0, name.size() - end.size())))
      return true;
  return holds(macros_of_the_library, name) || holds(other_words_of_mathematics, name) ||
         holds(words_of_the_library, name);
}

} // namespace kanexpr::base::library_words
