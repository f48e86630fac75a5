// SPDX-License-Identifier: MIT
#pragma once

// A control script similar to the one uploaded by Universal Robots' C++ client library. It connects to the
// client with three sockets (trajectory, script commands, reverse), servos, runs trajectories and splines,
// and executes commands in parallel. Written for these tests, it uses the built-in functions and language
// features that the script of library 2.14 relies on.

#include <QByteArray>

namespace tiller::test {

struct SocketPorts {
    int reverse = 50001;
    int trajectory = 50003;
    int command = 50004;
};

/// ending  statements after the control loop
inline QByteArray socketScript(const SocketPorts& ports, const QByteArray& ending = {}) {
    QByteArray text = R"(	def socket_control():
	# constants; PolyScope puts blanks or tabs before each line
	HOST = "127.0.0.1"
	MULT = 1000000
	steptime = get_steptime()
	STOPJ = 4.0
	MODE_STOPPED = -2  MODE_UNSET = -1  MODE_IDLE = 0  MODE_SERVOJ = 1
	MODE_SPEEDJ = 2
	MODE_FORWARD = 3
	MODE_SPEEDL = 4
	MODE_POSE = 5
	MODE_FREEDRIVE = 6
	MODE_CONTACT = 7
	MODE_TORQUE = 8
	SUCCESS = 0
	CANCELED = 1
	FAILURE = 2
	global control_mode = MODE_UNSET
	global thread_move = 0
	global thread_trajectory = 0
	global thread_contact = 0
	global contact_running = False
	global setpoint = get_joint_positions()
	global setpoint_new = False
	global twist = [0, 0, 0, 0, 0, 0]
	global qd_wanted = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0]
	global torque = [0, 0, 0, 0, 0, 0]
	global viscous_scale = [0.9, 0.9, 0.8, 0.9, 0.9, 0.9]
	global coulomb_scale = [0.8, 0.8, 0.7, 0.8, 0.8, 0.8]
	global friction_on = True
	global points_left = 0
	global result = 0
	global moving_spline = False
	global spline_qd = [0, 0, 0, 0, 0, 0]
	global skipped = 0

	def clamp_abs(value, most = 20.0):
	  if norm(value) > most:
	    if value > 0:
	      return most
	    end
	    return -1 * most
	  end
	  return value
	end
	def largest(list):
	  local max = 0.0
	  local i = 0
	  while i < get_list_length(list):
	    if norm(list[i]) > max:
	      max = norm(list[i])
	    end
	    i = i + 1
	  end
	  return max
	end
	def say(message, value = 0, warning = False):
	  textmsg(str_cat(
	    str_cat("control: ", message),
	      str_cat(" = ",
	        to_str(value))))
	  if warning:
	    popup(str_cat("<b>", str_cat(message, "</b> # not a comment")), title="Control", error=False,
	          warning=True, blocking=False)
	  end
	end

	# ---- servo, speed, torque threads -----------------------------------------------------------------
	thread servoThread():
	  textmsg("servo thread starts")
	  local state = MODE_IDLE
	  local last = get_joint_positions()
	  while control_mode == MODE_SERVOJ or
	        control_mode == MODE_POSE:
	    enter_critical
	    local q = setpoint
	    if setpoint_new:
	      setpoint_new = False
	      state = MODE_SERVOJ
	    else:
	      # Nothing new: go on as before.
	      q = last + get_target_joint_speeds() * steptime * 0
	    end
	    local jump = largest((q - last) / steptime)
	    exit_critical
	    if jump > 20 * 12.5:
	      skipped = skipped + 1
	      if skipped == 1: say("step too large", jump, warning = True) end
	      servoj(last, t=steptime, lookahead_time=0.03, gain=2000)
	    else:
	      last = q
	      servoj(q, t=steptime, lookahead_time=0.03, gain=2000)
	    end
	  end
	  textmsg("servo thread ends")
	  stopj(STOPJ)
	end
	thread speedjThread():
	  while control_mode == MODE_SPEEDJ:
	    speedj(qd_wanted, 40.0, steptime)
	  end
	  stopj(STOPJ)
	end
	thread speedlThread():
	  while control_mode == MODE_SPEEDL:
	    local xd = twist
	    speedl(xd, 40.0, steptime)
	  end
	  stopj(STOPJ)
	end
	thread torqueThread():
	  while control_mode == MODE_TORQUE:
	    if friction_on:
	      direct_torque(torque, viscous_scale=viscous_scale, coulomb_scale=coulomb_scale)
	    else:
	      direct_torque(torque, viscous_scale=[0, 0, 0, 0, 0, 0], coulomb_scale=[0, 0, 0, 0, 0, 0])
	    end
	  end
	  stopj(STOPJ)
	end

	# ---- trajectories ---------------------------------------------------------------------------------
	def spline_speed(s, c1, c2, c3, c4, c5, tt):
	  return (c1 + 2 * c2 * s + 3 * c3 * pow(s, 2) + 4 * c4 * pow(s, 3) + 5 * c5 * pow(s, 4)) / tt
	end
	def run_spline(q1, qd1, qdd1, tt, quintic = False):
	  local q0 = get_target_joint_positions()
	  local qd0 = spline_qd
	  local c1 = qd0 * tt
	  local c2 = [0, 0, 0, 0, 0, 0]
	  local c3 = c2
	  local c4 = c2
	  local c5 = c2
	  local b = qd1 * tt
	  if quintic:
	    local acc = qdd1 * pow(tt, 2)
	    c3 = 10 * (q1 - q0) - 6 * c1 - 4 * b + 0.5 * acc
	    c4 = -15 * (q1 - q0) + 8 * c1 + 7 * b - acc
	    c5 = 6 * (q1 - q0) - 3 * c1 - 3 * b + 0.5 * acc
	  else:
	    c2 = -3 * q0 + 3 * q1 - 2 * c1 - b
	    c3 = 2 * q0 - 2 * q1 + c1 + b
	  end
	  local spent = 0.0
	  while spent < tt:
	    local dt = steptime
	    if tt - spent < steptime:
	      dt = tt - spent
	    end
	    spent = spent + dt
	    local qd = spline_speed(spent / tt, c1, c2, c3, c4, c5, tt)
	    local qdd_max = 0
	    if dt > 0:
	      qdd_max = largest((qd - spline_qd) / dt)
	    end
	    speedj(qd, qdd_max, dt)
	    spline_qd = qd
	  end
	end
	def pose_of(raw, first):
	  return p[raw[first] / MULT, raw[first + 1] / MULT, raw[first + 2] / MULT, raw[first + 3] / MULT, raw[first + 4] / MULT, raw[first + 5] / MULT]
	end
	def list_of(raw, first):
	  return [raw[first], raw[first + 1], raw[first + 2], raw[first + 3], raw[first + 4], raw[first + 5]] / MULT
	end
	def run_point(raw):
	  local type = raw[21]
	  local q = list_of(raw, 1)
	  local target = pose_of(raw, 1)
	  local v = raw[13] / MULT
	  local a = raw[14] / MULT
	  local time = raw[19] / MULT
	  local r = raw[20] / MULT
	  if points_left == 0:
	    r = 0.0
	  end
	  if type == 0:
	    movej(q, a = a, v = v, t = time, r = r)
	  elif type == 1:
	    movel(target, a = a, v = v, t = time, r = r)
	  elif type == 2:
	    movep(target, a = a, v = v, r = r)
	  elif type == 3:
	    movec(pose_of(raw, 7), target, a = a, v = v, r = r, mode = floor(raw[15] / MULT))
	  elif type == 4:
	    optimovej(q, a = a, v = v, r = r)
	  elif type == 5:
	    optimovel(target, a = a, v = v, r = r)
	  elif type == 6:
	    if raw[15] != 0:
	      movej(get_inverse_kin(target, qnear=list_of(raw, 7)), a=a, v=v, t=time, r=r)
	    else:
	      movej(target, a=a, v=v, t=time, r=r)
	    end
	  elif type == 7:
	    movel(q, a=a, v=v, t=time, r=r)
	  elif type == 8:
	    movep(q, a=a, v=v, r=r)
	  elif type == 51:
	    if not moving_spline:
	      spline_qd = get_target_joint_speeds()
	      moving_spline = True
	    end
	    run_spline(q, list_of(raw, 7), list_of(raw, 13), time, quintic = raw[20] == 2)
	  else:
	    say("unknown motion", type)
	  end
	  if type != 51:
	    moving_spline = False
	  end
	end
	thread trajectoryThread():
	  textmsg("trajectory with points: ", points_left)
	  moving_spline = False
	  local result_now = SUCCESS
	  while points_left > 0:
	    local wait = 0.5
	    if moving_spline:
	      wait = steptime
	    end
	    local raw = socket_read_binary_integer(6 + 6 + 6 + 1 + 1 + 1, "trajectory", wait)
	    if raw[0] > 0:
	      points_left = points_left - 1
	      run_point(raw)
	    else:
	      textmsg("no point within ", wait)
	      result_now = FAILURE
	      points_left = 0
	    end
	  end
	  stopj(STOPJ)
	  enter_critical
	  result = result_now
	  socket_send_int(result, "trajectory")
	  thread_trajectory = 0
	  exit_critical
	end
	def cancel_trajectory():
	  if thread_trajectory != 0:
	    kill thread_trajectory
	    thread_trajectory = 0
	    # Data that the client has already sent do not belong to the next trajectory.
	    local rest = 0
	    while rest < 10:
	      local unread = socket_read_binary_integer(21, "trajectory", steptime)
	      if unread[0] <= 0:
	        rest = 10
	      end
	      rest = rest + 1
	    end
	    stopj(STOPJ)
	    points_left = 0
	    socket_send_int(CANCELED, "trajectory")
	  end
	end

	# ---- tool contact and commands beside the motion --------------------------------------------------
	thread contactThread():
	  while contact_running:
	    local speed = get_actual_tcp_speed()
	    local steps = tool_contact(direction=speed)
	    if steps > 0:
	      enter_critical
	      contact_running = False
	      control_mode = MODE_CONTACT
	      kill thread_move
	      stopl(3)
	      exit_critical
	      movel(get_actual_joint_positions_history(steps))
	      socket_send_int(0, "command")
	    end
	    sync()
	  end
	end
	thread commandThread():
	  while control_mode > MODE_STOPPED:
	    local raw = socket_read_binary_integer(28, "command", 0)
	    if raw[0] > 0:
	      local command = raw[1]
	      if command == 0:
	        zero_ftsensor()
	      elif command == 1:
	        set_payload(raw[2] / MULT, [raw[3] / MULT, raw[4] / MULT, raw[5] / MULT])
	      elif command == 2:
	        set_tool_voltage(raw[2] / MULT)
	      elif command == 3:
	        force_mode_set_damping(raw[27] / MULT)
	        force_mode_set_gain_scaling(raw[28] / MULT)
	        force_mode(pose_of(raw, 2), list_of(raw, 8), list_of(raw, 14), raw[20] / MULT, list_of(raw, 21))
	      elif command == 4:
	        end_force_mode()
	      elif command == 5:
	        contact_running = True
	        thread_contact = run contactThread()
	      elif command == 6:
	        if contact_running:
	          contact_running = False
	          socket_send_int(1, "command")
	        end
	        join thread_contact
	      elif command == 7:
	        friction_on = raw[2] != 0
	      elif command == 8:
	        ft_rtde_input_enable(raw[2] != 0, raw[3] / MULT, [raw[4] / MULT, raw[5] / MULT, raw[6] / MULT], [raw[7] / MULT, raw[8] / MULT, raw[9] / MULT])
	      elif command == 9:
	        set_gravity([raw[2] / MULT, raw[3] / MULT, raw[4] / MULT])
	      elif command == 10:
	        set_tcp(pose_of(raw, 2))
	      elif command == 11:
	        viscous_scale = list_of(raw, 2)
	        coulomb_scale = list_of(raw, 8)
	      elif command == 12:
	        set_target_payload(raw[2] / MULT, [raw[3] / MULT, raw[4] / MULT, raw[5] / MULT], list_of(raw, 6), raw[12] / MULT)
	      end
	    end
	  end
	end

	# ---- the loop -------------------------------------------------------------------------------------
	def leave_mode():
	  if control_mode == MODE_FREEDRIVE:
	    end_freedrive_mode()
	  end
	  if control_mode == MODE_FORWARD:
	    cancel_trajectory()
	  end
	  if thread_move != 0:
	    kill thread_move
	    thread_move = 0
	    stopj(STOPJ)
	  end
	end

	socket_close("trajectory")
	socket_close("command")
	socket_close("reverse")
	connected = socket_open(HOST, %TRAJECTORY%, "trajectory")
	connected = socket_open(HOST, %COMMAND%, "command") and connected
	connected = socket_open(HOST, %REVERSE%, "reverse") and connected
	if not connected:
	  popup("The client does not listen", title="Control", error=True, blocking=False)
	  halt
	end
	global thread_command = run commandThread()
	read_timeout = 0.0
	while control_mode > MODE_STOPPED:
	  enter_critical
	  raw = socket_read_binary_integer(1 + 6 + 1, "reverse", read_timeout)
	  if raw[0] > 0:
	    read_timeout = raw[1] / 1000.0
	    if control_mode != raw[8] and not (control_mode == MODE_CONTACT and raw[8] > 0):
	      leave_mode()
	      control_mode = raw[8]
	      setpoint = get_joint_positions()
	      setpoint_new = False
	      if control_mode == MODE_SERVOJ or control_mode == MODE_POSE:
	        thread_move = run servoThread()
	      elif control_mode == MODE_SPEEDJ:
	        thread_move = run speedjThread()
	      elif control_mode == MODE_SPEEDL:
	        thread_move = run speedlThread()
	      elif control_mode == MODE_TORQUE:
	        thread_move = run torqueThread()
	      end
	    end
	    if control_mode == MODE_SERVOJ:
	      setpoint = list_of(raw, 2)
	      setpoint_new = True
	    elif control_mode == MODE_POSE:
	      setpoint = get_inverse_kin(pose_of(raw, 2), setpoint)
	      setpoint_new = True
	    elif control_mode == MODE_SPEEDJ:
	      local i = 0
	      while i < 6:
	        qd_wanted[i] = clamp_abs(raw[2 + i] / MULT)
	        i = i + 1
	      end
	    elif control_mode == MODE_SPEEDL:
	      twist = list_of(raw, 2)
	    elif control_mode == MODE_TORQUE:
	      torque = list_of(raw, 2)
	    elif control_mode == MODE_FREEDRIVE:
	      if raw[2] == 1:
	        freedrive_mode()
	      elif raw[2] == -1:
	        end_freedrive_mode()
	      end
	    elif control_mode == MODE_FORWARD:
	      if raw[2] == 1:
	        points_left = raw[3]
	        thread_trajectory = run trajectoryThread()
	      elif raw[2] == -1:
	        cancel_trajectory()
	      end
	    end
	  else:
	    textmsg("the client is silent after ", read_timeout)
	    end_freedrive_mode()
	    kill thread_trajectory
	    kill thread_move
	    stopj(STOPJ)
	    halt
	  end
	  exit_critical
	end
	leave_mode()
	join thread_move
	kill thread_command
	stopj(STOPJ)
	socket_close("trajectory")
	socket_close("command")
	socket_close("reverse")
%ENDING%
	end
)";
    text.replace("%TRAJECTORY%", QByteArray::number(ports.trajectory));
    text.replace("%COMMAND%", QByteArray::number(ports.command));
    text.replace("%REVERSE%", QByteArray::number(ports.reverse));
    text.replace("%ENDING%", ending);
    return text;
}

}  // namespace tiller::test
