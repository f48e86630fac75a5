/* SPDX-License-Identifier: MIT */
/* Uses every function of the C interface. Exits with the line number of the first failure: c_program <host> */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "tiller_c.h"

#define CHECK(condition)                                                                      \
    do {                                                                                      \
        if (!(condition)) {                                                                   \
            fprintf(stderr, "line %d: %s (%s)\n", __LINE__, #condition, tiller_last_error()); \
            return 1;                                                                         \
        }                                                                                     \
    } while (0)

int main(int argc, char** argv) {
    tiller_robot* robot = NULL;
    double q[6];
    double pose[6];
    double mode = 0;
    double x = 0;
    int count = 0;

    CHECK(argc == 2);
    CHECK(tiller_version() == TILLER_C_VERSION);
    CHECK(tiller_connect(NULL, 1.0, &robot) == TILLER_INVALID_ARGUMENT && robot == NULL);
    CHECK(tiller_connect("127.0.0.1", 1.0, NULL) == TILLER_INVALID_ARGUMENT);
    CHECK(tiller_move_j(NULL, q, 0, 0) == TILLER_INVALID_ARGUMENT);
    CHECK(strstr(tiller_last_error(), "NULL") != NULL);
    CHECK(tiller_in_control(NULL) == 0 && tiller_is_active(NULL) == 0);
    tiller_close(NULL);

    CHECK(tiller_connect(argv[1], 10.0, &robot) == TILLER_OK);
    CHECK(strlen(tiller_last_error()) == 0);
    CHECK(tiller_read(robot, "actual_q", q, 6, &count) == TILLER_OK && count == 6);
    CHECK(tiller_read(robot, "robot_mode", &mode, 1, NULL) == TILLER_OK && mode == 7);
    CHECK(tiller_read(robot, "actual_q", q, 5, &count) == TILLER_LIMIT_EXCEEDED && count == 6);
    CHECK(tiller_read(robot, "actual_qq", q, 6, NULL) == TILLER_FIELD_UNKNOWN);
    CHECK(strstr(tiller_last_error(), "actual_q") != NULL);
    CHECK(tiller_read(robot, NULL, q, 6, NULL) == TILLER_INVALID_ARGUMENT);
    CHECK(tiller_read(robot, "actual_q", NULL, 6, NULL) == TILLER_INVALID_ARGUMENT);
    CHECK(tiller_move_j(robot, q, 0, 0) == TILLER_NOT_IN_CONTROL);
    CHECK(tiller_wait(robot, 1.0) == TILLER_NOT_IN_CONTROL);

    CHECK(tiller_take_control(robot, 20.0) == TILLER_OK && tiller_in_control(robot) == 1);
    CHECK(tiller_set_speed_cap(robot, 100.0) == TILLER_LIMIT_EXCEEDED);
    CHECK(tiller_set_speed_cap(robot, 0.2) == TILLER_OK);
    CHECK(tiller_move_j(robot, NULL, 0, 0) == TILLER_INVALID_ARGUMENT);
    q[5] = NAN;
    CHECK(tiller_move_j(robot, q, 0, 0) == TILLER_INVALID_ARGUMENT);
    CHECK(tiller_read(robot, "actual_q", q, 6, NULL) == TILLER_OK);
    x = q[5];
    q[5] += 0.3;
    CHECK(tiller_move_j(robot, q, -1.0, 0) == TILLER_INVALID_ARGUMENT);
    CHECK(tiller_move_j(robot, q, 1.0, 0) == TILLER_OK && tiller_is_active(robot) == 1);
    CHECK(tiller_wait(robot, 30.0) == TILLER_OK && tiller_is_active(robot) == 0);
    CHECK(tiller_read(robot, "actual_q", q, 6, NULL) == TILLER_OK && fabs(q[5] - x - 0.3) < 0.01);

    CHECK(tiller_read(robot, "actual_TCP_pose", pose, 6, NULL) == TILLER_OK);
    pose[2] += 0.1;
    CHECK(tiller_move_l(robot, pose, 2.0, 0) == TILLER_LIMIT_EXCEEDED);
    CHECK(tiller_wait(robot, 1.0) == TILLER_LIMIT_EXCEEDED);
    CHECK(tiller_move_l(robot, pose, 0, 0) == TILLER_OK);
    CHECK(tiller_wait(robot, 0.0) == TILLER_TIMEOUT);
    CHECK(tiller_stop(robot) == TILLER_OK && tiller_is_active(robot) == 0);
    CHECK(tiller_wait(robot, -1.0) == TILLER_STOPPED);

    CHECK(tiller_set_digital_output(robot, 99, 1, 3.0) == TILLER_INVALID_ARGUMENT);
    CHECK(tiller_set_digital_output(robot, 3, 1, 10.0) == TILLER_OK);
    CHECK(tiller_read(robot, "actual_digital_output_bits", &x, 1, NULL) == TILLER_OK && x == 8);
    CHECK(tiller_release(robot) == TILLER_OK && tiller_in_control(robot) == 0);
    CHECK(tiller_move_l(robot, pose, 0, 0) == TILLER_NOT_IN_CONTROL);
    tiller_close(robot);
    CHECK(tiller_connect("127.0.0.1", 1.0, &robot) == TILLER_CONNECTION_REFUSED && robot == NULL);
    puts("done");
    return 0;
}
