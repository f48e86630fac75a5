// SPDX-License-Identifier: MIT
#pragma once

// A control script similar to the one uploaded by ur_rtde. It reads commands from input registers and replies
// in output registers. It has servo, speed, force, jog, path and contact threads. Written for these tests, it
// uses the built-in functions and language features that the script of ur_rtde 1.5.8 relies on.

#include <QByteArray>

namespace tiller::test {

/// offset  register offset, 0 or 24
/// path    statements of an inserted path; empty if there is none
inline QByteArray registerScript(int offset = 0, const QByteArray& path = {}) {
    QByteArray text = R"(
def register_control():
    # The client puts the number of the first register behind the comment, on the line below.
    global base_f = # float registers
%OFFSET%    global base_i = # integer registers
%OFFSET%

    ### what the threads work on
    global move_thrd = 0    global jog_thrd = 0
    global servo_thrd = 0
    global speed_thrd = 0
    global force_thrd = 0
    global contact_thrd = 0
    global path_thrd = 0
    global goal = p[0, 0, 0, 0, 0, 0]
    global v = 0.25    global a = 1.2    global t = 0.002
    global lookahead = 0.1
    global gain = 300
    global blend = 0.0
    global rate = [0, 0, 0, 0, 0, 0]
    global kind = 0
    global frame = p[0, 0, 0, 0, 0, 0]
    global selection_vector = [0, 0, 0, 0, 0, 0]
    global wrench = [0, 0, 0, 0, 0, 0]
    global limits = [0.1, 0.1, 0.1, 0.1, 0.1, 0.1]
    global force_type = 2
    global direction = p[0, 0, 0, 0, 0, 0]
    global touched = 0
    global stop_type = 0
    global turn = 0
    global jog_feature = 0
    global servoing_circles = False

    def f_in(n):
        return read_input_float_register(base_f + n)
    end
    def i_in(n): return read_input_integer_register (n + base_i) end
    def answer(state):
        write_output_integer_register(base_i + 0, state)
    end
    def result_int(value):
        write_output_integer_register(base_i + 1, value)
    end
    def results(p):
        local n = 0
        while n < 6:
            write_output_float_register(base_f + n, p[n])
            n = n + 1
        end
    end
    def joints(first):
        return [f_in(first), f_in(first + 1), f_in(first + 2), f_in(first + 3), f_in(first + 4), f_in(first + 5)]
    end
    def pose(first):
        return p[f_in(first), f_in(first + 1), f_in(first + 2), f_in(first + 3), f_in(first + 4), f_in(first + 5)]
    end
    def scale_pose(p, factor):
        p[0] = p[0] * factor
        p[1] = p[1] * factor
        p[2] = p[2] * factor
        return p
    end
    def pose_is_null(p):
        local sum = norm(p[0]) + norm(p[1]) + norm(p[2]) + norm(p[3]) + norm(p[4]) + norm(p[5])
        return (sum < 0.0000000001)
    end
    # Progress of an asynchronous operation: number, count of changes, running, steps.
    global operation = 0    global changes = 0
    def progress(running, steps):
        changes = (changes + 1) % 128
        local word = operation * 16777216 + changes * 65536 + steps
        if running:
            word = word + 32768
        end
        write_output_integer_register(base_i + 2, word)
    end
    def begin_operation():
        operation = (operation + 1) % 127
        progress(True, 0)
    end

    thread move_thread():
        enter_critical
        begin_operation()
        exit_critical
        if kind == 1:
            movej([goal[0], goal[1], goal[2], goal[3], goal[4], goal[5]], a = a, v = v)
        elif kind == 2:
            movej(get_inverse_kin(goal), a=a, v=v)
        elif kind == 3:
            movel(goal, a=a, v=v)
        else:
            movel([goal[0], goal[1], goal[2], goal[3], goal[4], goal[5]], a=a, v=v)
        end
        enter_critical
        progress(False, 0)
        move_thrd = 0
        exit_critical
    end
    thread servo_thread():
        while (True):
            if servoing_circles:
                servoc(goal, a, v, blend)
            else:
                servoj([goal[0], goal[1], goal[2], goal[3], goal[4], goal[5]], a, v, t, lookahead, gain)
            end
        end
    end
    thread speed_thread():
        while True:
            if kind == 9 and t > 0:
                speedj(rate, a, t)
            elif kind == 9:
                speedj(rate, a)
            elif t > 0:
                speedl(rate, a, t)
            else:
                speedl(rate, a)
            end
        end
    end
    thread force_thread():
        while True:
            force_mode(frame, selection_vector, wrench, force_type, limits)
            sync()
        end
    end
    thread jog_thread():
        while True:
            local xd = p[rate[0], rate[1], rate[2], rate[3], rate[4], rate[5]]
            if jog_feature == 1:
                local there = get_forward_kin()
                there = p[0, 0, 0, there[3], there[4], there[5]]
                local lin = pose_trans(there, p[xd[0], xd[1], xd[2], 0, 0, 0])
                local rot = pose_trans (there, p[xd[3], xd[4], xd[5], 0, 0, 0])
                xd = p[lin[0], lin[1], lin[2], rot[0], rot[1], rot[2]]
            end
            speedl([xd[0], xd[1], xd[2], xd[3], xd[4], xd[5]], a, get_steptime())
        end
    end
    thread contact_thread():
        while True:
            local way = direction
            if pose_is_null(way):
                # No direction given: that of the motion.
                way = get_target_tcp_speed()
            end
            touched = tool_contact(way)
            if touched > 0:
                textmsg("contact ", touched)
            end
            sync()
        end
    end
    thread path_thread():
        exec_path()
        enter_critical
        progress(False, turn)
        path_thrd = 0
        exit_critical
    end
    def exec_path():
        turn = 0
        # inject path here
%PATH%
        textmsg("path done")
    end

    def end_threads():
        if move_thrd != 0:
            kill move_thrd
            move_thrd = 0
        end
        if path_thrd != 0:
            kill path_thrd
            path_thrd = 0
        end
        if servo_thrd != 0:
            kill servo_thrd
            servo_thrd = 0
        end
        if speed_thrd != 0:
            kill speed_thrd
            speed_thrd = 0
        end
        if jog_thrd != 0:
            kill jog_thrd
            jog_thrd = 0
        end
    end

    def move(cmd):
        enter_critical
        goal = p[f_in(0), f_in(1), f_in(2), f_in(3), f_in(4), f_in(5)]
        v = f_in(6)
        a = f_in(7)
        kind = cmd
        exit_critical
        if i_in(1) == 1:
            if move_thrd != 0:
                kill move_thrd
            end
            global move_thrd = run move_thread()
        elif cmd == 1:
            movej(joints(0), a=a, v=v)
        elif cmd == 2:
            movej(get_inverse_kin(goal), a=a, v=v)
        elif cmd == 3:
            movel(goal, a=a, v=v)
        else:
            movel(joints(0), a=a, v=v)
        end
    end
    def servo(cmd):
        enter_critical
        servoing_circles = cmd == 12
        if cmd == 24:
            local q = get_inverse_kin(pose(0))
            goal = p[q[0], q[1], q[2], q[3], q[4], q[5]]
        else:
            goal = pose(0)
        end
        v = f_in(6)
        a = f_in(7)
        if servoing_circles:
            blend = f_in(8)
        else:
            t = f_in(8)
            lookahead = f_in(9)
            gain = f_in(10)
        end
        exit_critical
        if servo_thrd == 0:
            global servo_thrd = run servo_thread()
        end
    end
    def speed(cmd):
        enter_critical
        rate = joints(0)
        a = f_in(6)
        t = f_in(7)
        kind = cmd
        exit_critical
        if speed_thrd == 0:
            global speed_thrd = run speed_thread()
        end
    end
    def force():
        enter_critical
        force_type = i_in(1)
        local n = 0
        while n < 6:
            selection_vector[n] = i_in(2 + n)
            wrench[n] = f_in(6 + n)
            limits[n] = f_in(12 + n)
            n = n + 1
        end
        frame = pose(0)
        exit_critical
        if force_thrd == 0:
            global force_thrd = run force_thread()
        end
    end
    def until_contact():
        local xd = joints(0)
        local way = pose(6)
        if pose_is_null(way):
            way = p[xd[0], xd[1], xd[2], 0, 0, 0]
        end
        while tool_contact(way) != 0:
            sync()
        end
        local steps = tool_contact(way)
        while steps == 0:
            speedl(xd, f_in(12), get_steptime())
            steps = tool_contact(way)
        end
        local q = get_actual_joint_positions_history(steps)
        stopl(3)
        movel(q)
    end

    # Executed once each. False ends the program.
    def process(cmd):
        if cmd >= 1 and cmd <= 4:
            move(cmd)
        elif cmd == 7:
            if force_thrd != 0:
                kill force_thrd
                force_thrd = 0
            end
            end_force_mode()
            stopl(10)
        elif cmd == 8:
            zero_ftsensor()
        elif cmd == 12:
            servo(cmd)
        elif cmd == 15 or
             cmd == 16:
            end_threads()
            stopj(f_in(0))
        elif cmd == 17:
            local cog = [f_in(1), f_in(2), f_in(3)]
            if norm(cog) == 0:
                cog = get_target_payload_cog()
            end
            set_payload(f_in(0), cog)
        elif cmd == 18: teach_mode()
        elif cmd == 19: end_teach_mode()
        elif cmd == 20: force_mode_set_damping(f_in(0))
        elif cmd == 21: force_mode_set_gain_scaling(f_in(0))
        elif cmd == 28: results(get_target_waypoint())
        elif cmd == 29: set_tcp(pose(0))
        elif cmd == 30: results(get_inverse_kin(pose(0), joints(6), f_in(12), f_in(13)))
        elif cmd == 31: protective_stop()
        elif cmd == 33 or cmd == 34:
            if i_in(1) == 1:
                stop_type = 1
            end
            end_threads()
            if stop_type == 1:
                stopl(f_in(0))
            else:
                stopj(f_in(0))
            end
        elif cmd == 35: rtde_set_watchdog("input_int_register_%OFFSET%", f_in(0), "stop")
        elif cmd == 36 or cmd == 37:
            local inside = 0
            if cmd == 36:
                if is_within_safety_limits(pose(0)): inside = 1 end
            elif is_within_safety_limits(joints(0)):
                inside = 1
            end
            result_int(inside)
        elif cmd == 39: results(pose_trans(pose(0), pose(6)))
        elif cmd == 40: results(get_tcp_offset())
        elif cmd == 41:
            enter_critical
            rate = joints(0)
            jog_feature = f_in(6)
            a = f_in(7)
            exit_critical
            if jog_thrd == 0:
                global jog_thrd = run jog_thread()
            end
        elif cmd == 42:
            end_threads()
            stopl(10)
        elif cmd == 43: results(get_forward_kin())
        elif cmd == 44: results(get_forward_kin(joints(0), pose(6)))
        elif cmd == 45:
            begin_operation()
            if i_in(1) == 1:
                global path_thrd = run path_thread()
            else:
                exec_path()
                progress(False, turn)
            end
        elif cmd == 46: results(get_inverse_kin(pose(0)))
        elif cmd == 47:
            if is_steady():
                result_int(1)
            else:
                result_int(0)
            end
        elif cmd == 51: until_contact()
        elif cmd == 52:
            freedrive_mode(freeAxes=[i_in(1), i_in(2), i_in(3), i_in(4), i_in(5), i_in(6)], feature=pose(0))
        elif cmd == 53: end_freedrive_mode()
        elif cmd == 54: result_int(get_freedrive_status())
        elif cmd == 56:
            ft_rtde_input_enable(i_in(1) == 1, f_in(0), [f_in(1), f_in(2), f_in(3)], [f_in(4), f_in(5), f_in(6)])
        elif cmd == 57:
            enable_external_ft_sensor(i_in(1) == 1, f_in(0), [f_in(1), f_in(2), f_in(3)], [f_in(4), f_in(5), f_in(6)])
        elif cmd == 59: set_gravity([f_in(0), f_in(1), f_in(2)])
        elif cmd == 60 or cmd == 61:
            local found = False
            if cmd == 60:
                found = get_inverse_kin_has_solution(pose(0))
            else:
                found = get_inverse_kin_has_solution(pose(0), joints(6), f_in(12), f_in(13))
            end
            if found == True: result_int(1) else: result_int(0) end
        elif cmd == 62:
            direction = pose(0)
            touched = 0
            if contact_thrd == 0:
                global contact_thrd = run contact_thread()
            end
        elif cmd == 63:
            if contact_thrd != 0:
                kill contact_thrd
                contact_thrd = 0
            end
            result_int(touched)
        elif cmd == 64: result_int(touched)
        elif cmd == 70:
            # Nothing a client asks for: what the language must do besides.
            local moved = scale_pose(pose(0), 0.5)
            results(pose_sub(moved, get_actual_tcp_pose()))
            result_int(floor(get_target_payload()))
        elif cmd == 255:
            return False
        else:
            textmsg("unknown command ", cmd)
        end
        return True
    end
    # Executed in every frame as long as the register holds them.
    def process_each_frame(cmd):
        if cmd == 6:
            force()
        elif cmd == 9 or cmd == 10:
            speed(cmd)
        elif cmd == 11 or cmd == 24:
            servo(cmd)
        elif cmd == 25:
            result_int(tool_contact(joints(0)))
        elif cmd == 26:
            write_output_float_register(base_f, get_steptime())
        elif cmd == 27:
            results(get_actual_joint_positions_history(i_in(1)))
        elif cmd == 38:
            results(get_joint_torques())
        elif cmd == 58:
            results(get_actual_tool_flange_pose())
        else:
            return False
        end
        return True
    end

    keep_running = True
    executing = False
    answer(1)
    while keep_running:
        cmd = i_in(0)
        if cmd == 0:
            executing = False
            answer(1)
        elif process_each_frame(cmd):
            answer(2)
            answer(1)
        elif not executing:
            keep_running = process(cmd)
            executing = True
            answer(2)
        end
        sync()
    end
    end_threads()
    textmsg("control script ends")
end
)";
    text.replace("%OFFSET%", QByteArray::number(offset));
    text.replace("%PATH%", path);
    return text;
}

}  // namespace tiller::test
