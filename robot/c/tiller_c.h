/* SPDX-License-Identifier: MIT */
/*
 * Tiller for C, and for programs that load C libraries: MATLAB loadlibrary, LabVIEW, Octave, Python ctypes.
 * Link with -ltiller_c.
 *
 *   tiller_robot* robot = NULL;
 *   if (tiller_connect("192.168.0.10", 5.0, &robot) != TILLER_OK) { puts(tiller_last_error()); return 1; }
 *   tiller_take_control(robot, 10.0);
 *   tiller_move_l(robot, pose, 0.1, 0.0);
 *   tiller_wait(robot, 30.0);
 *   tiller_close(robot);
 *
 * Units: m, rad, s, N, Nm, A, kg. Joints from base to wrist 3; poses are position and rotation vector of the TCP in the
 * base frame. Every function returns TILLER_OK or an error code, unless documented otherwise. tiller_last_error()
 * returns the text of the error. Timeouts are in seconds; a negative timeout means no limit.
 *
 * A newer motion, tiller_stop(), tiller_release() and tiller_close() end a motion. A motion also ends when this process
 * ends in any way, hangs or loses the connection: the robot brakes if it receives no heartbeat for 100 ms.
 *
 * Threads: any. tiller_close() must be the last call with a robot. A child process created with fork() cannot use the
 * robot.
 */
#ifndef TILLER_C_H
#define TILLER_C_H

#ifdef __cplusplus
extern "C" {
#endif

#if defined(_WIN32) && defined(TILLER_C_BUILD)
#define TILLER_C_API __declspec(dllexport)
#elif defined(_WIN32)
#define TILLER_C_API __declspec(dllimport)
#elif defined(__GNUC__)
#define TILLER_C_API __attribute__((visibility("default")))
#else
#define TILLER_C_API
#endif

/* Incremented only when a function is removed or changed, not when functions are added. */
#define TILLER_C_VERSION 1

/* The values are the same in all versions. */
enum tiller_status {
    TILLER_OK = 0,
    TILLER_ADDRESS_INVALID = 1,
    TILLER_HOST_UNREACHABLE = 2,
    TILLER_CONNECTION_REFUSED = 3,
    TILLER_CONNECTION_CLOSED = 4,
    TILLER_TIMEOUT = 5,
    TILLER_CANCELLED = 6,
    TILLER_LINK_LOST = 7,
    TILLER_PROTOCOL_ERROR = 8,
    TILLER_VERSION_UNSUPPORTED = 9,
    TILLER_FIELD_UNKNOWN = 10,
    TILLER_REGISTER_IN_USE = 11,
    TILLER_NOT_CONNECTED = 12,
    TILLER_NOT_IN_CONTROL = 13,
    TILLER_UNSAFE_STATE = 14,
    TILLER_REMOTE_CONTROL_REQUIRED = 15,
    TILLER_LIMIT_EXCEEDED = 16,
    TILLER_INVALID_ARGUMENT = 17,
    TILLER_NO_SOLUTION = 18,
    TILLER_STOPPED = 19,
    TILLER_REJECTED = 20,
    TILLER_SCRIPT_ERROR = 21,
    TILLER_FILE_NOT_READABLE = 22,
    TILLER_FILE_NOT_WRITABLE = 23,
    TILLER_FILE_CORRUPT = 24,
    TILLER_DISK_FULL = 25,
    TILLER_INTERNAL = 26
};

typedef struct tiller_robot tiller_robot;

/* TILLER_C_VERSION of the library. Never fails. */
TILLER_C_API int tiller_version(void);

/* Text of the last error in this thread, in UTF-8; empty after a successful call. Valid until the next call to this
 * library in this thread. */
TILLER_C_API const char* tiller_last_error(void);

/* Connects and waits for the first data. On failure *robot is NULL. */
TILLER_C_API int tiller_connect(const char* host, double timeout, tiller_robot** robot);

/* Stops the arm, releases control, closes the connection and frees the robot. No effect for NULL. */
TILLER_C_API void tiller_close(tiller_robot* robot);

/* Copies the newest value of an RTDE output such as "actual_q" or "robot_mode" into `values`. `capacity` is the size of
 * `values`. *count is set to the number of values of the field; `count` may be NULL. Integers are exact.
 * TILLER_FIELD_UNKNOWN if the field is not received; TILLER_LIMIT_EXCEEDED if `capacity` is too small;
 * TILLER_LINK_LOST if the newest packet is older than 100 ms (the values are still copied). Does not wait. */
TILLER_C_API int tiller_read(tiller_robot* robot, const char* field, double* values, int capacity,
                             int* count);

/* Sends the control program to the robot. This ends the program that is running on the robot. */
TILLER_C_API int tiller_take_control(tiller_robot* robot, double timeout);

/* Stops the arm and releases control. */
TILLER_C_API int tiller_release(tiller_robot* robot);

/* 1 if motions can be commanded, else 0. */
TILLER_C_API int tiller_in_control(tiller_robot* robot);

/* Speed limit of the TCP and the elbow for all motions [m/s], 0.25 by default. A change ends the active motion. */
TILLER_C_API int tiller_set_speed_cap(tiller_robot* robot, double speed);

/* Starts a move in joint space to joint positions [rad]. Does not wait. speed [rad/s] and acceleration [rad/s2] of the
 * joint with the largest rotation; 0: default (1.05 and 1.4). */
TILLER_C_API int tiller_move_j(tiller_robot* robot, const double q[6], double speed, double acceleration);

/* Starts a move of the TCP on a straight line to a pose [m, rad]. Does not wait. speed [m/s], acceleration [m/s2]; 0:
 * default (0.25 or the cap, and 1.2). */
TILLER_C_API int tiller_move_l(tiller_robot* robot, const double pose[6], double speed, double acceleration);

/* Waits until the last motion has reached its target. Returns TILLER_STOPPED or another error if the motion ended
 * earlier, or the error of the start if the motion was refused. After TILLER_TIMEOUT the motion continues. */
TILLER_C_API int tiller_wait(tiller_robot* robot, double timeout);

/* 1 until the last started motion has reached its target or was stopped, else 0. */
TILLER_C_API int tiller_is_active(tiller_robot* robot);

/* Ends the active motion. No earlier command can move the arm afterwards. Does not wait. Not an emergency stop. */
TILLER_C_API int tiller_stop(tiller_robot* robot);

/* Sets a digital output: 0-7 standard, 8-15 configurable, 16-17 tool. Returns when the robot reports the new state. */
TILLER_C_API int tiller_set_digital_output(tiller_robot* robot, int output, int on, double timeout);

#ifdef __cplusplus
}
#endif

#endif
