// SPDX-License-Identifier: MIT
// Leans on what ur_rtde's headers bring along, as programs of its users do.
#include <ur_rtde/rtde_control_interface.h>
#include <ur_rtde/rtde_receive_interface.h>

int main(int argc, char** argv) {
    std::ofstream log("/dev/null");
    std::ostringstream text;
    std::map<std::string, std::tuple<double, int>> times;
    std::unique_ptr<ur_rtde::RTDEControlInterface> control;
    std::atomic<bool> running{false};
    std::function<double(double)> turn = [](double angle) { return std::cos(angle); };
    text << std::setprecision(3) << turn(0);
    log << text.str() << times.size() << std::endl;
    ur_rtde::AsyncOperationStatus status = 5;
    if (argc > 1) {
        control.reset(new ur_rtde::RTDEControlInterface(argv[1]));
        running = control->versions().major > 0 && !control->serial_number().empty();
    }
    return status.progress() == -1 ? 0 : 1;
}
