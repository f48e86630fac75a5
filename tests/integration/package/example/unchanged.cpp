// SPDX-License-Identifier: MIT
// Relies on indirect includes of ur_rtde's headers, like the programs of its users.
#include <ur_rtde/robot_state.h>
#include <ur_rtde/rtde.h>
#include <ur_rtde/rtde_control_interface.h>
#include <ur_rtde/rtde_export.h>
#include <ur_rtde/rtde_receive_interface.h>

using namespace ur_rtde;
using namespace std::chrono;

bool running = true;
void raiseFlag(int) {
    running = false;
}

RTDE_EXPORT std::vector<double> home() {
    return {0, -M_PI / 2, 0, -M_PI / 2, 0, 0};
}

int main(int argc, char** argv) {
    signal(SIGINT, raiseFlag);
    usleep(1);
    std::vector<double> sorted = home();
    std::sort(sorted.begin(), sorted.end());
    double sum = std::accumulate(sorted.begin(), sorted.end(), 0.0);
    std::mutex mutex;
    std::lock_guard<std::mutex> lock(mutex);
    printf("%.1f %zu\n", sum, strlen("done"));
    std::ofstream log("/dev/null");
    std::ostringstream text;
    std::map<std::string, std::tuple<double, int>> times;
    std::unique_ptr<ur_rtde::RTDEControlInterface> control;
    std::atomic<bool> known{false};
    std::function<double(double)> turn = [](double angle) { return std::cos(angle); };
    text << std::setprecision(3) << turn(0);
    log << text.str() << times.size() << std::endl;
    double speed = std::min(5.0, UR_JOINT_VELOCITY_MAX), gain = std::max(20, UR_SERVO_GAIN_MIN);
    log << speed << gain << UR_BLEND_MAX << UR_SERVO_LOOKAHEAD_TIME_MIN << RT_PRIORITY_UNDEFINED;
    ur_rtde::AsyncOperationStatus status = 5;
    if (argc > 1) {
        control.reset(new ur_rtde::RTDEControlInterface(argv[1]));
        known = control->versions().major > 0 && !control->serial_number().empty();
    }
    return status.progress() == -1 ? 0 : 1;
}
