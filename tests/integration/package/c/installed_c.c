/* SPDX-License-Identifier: MIT */
/* Compiled and linked against the installed C interface. python/test_c checks its functions with a robot. */
#include <stdio.h>
#include <string.h>
#include <tiller_c.h>

int main(void) {
    tiller_robot* robot = NULL;
    if (tiller_version() != TILLER_C_VERSION ||
        tiller_connect(NULL, 1.0, &robot) != TILLER_INVALID_ARGUMENT || strlen(tiller_last_error()) == 0) {
        return 1;
    }
    printf("%s\n", tiller_last_error());
    return 0;
}
