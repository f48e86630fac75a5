# SPDX-License-Identifier: MIT
# Listing 5 of the ur_rtde paper.
import roboticstoolbox as rtb
import numpy as np
import spatialmath as sm
from rtde_control import RTDEControlInterface

rtde_c = RTDEControlInterface("localhost")

# Parameters
dt = 1.0/500 # 2ms
lookahead_time = 0.1
gain = 300

# Cartesian poses
T0 = sm.SE3(0.36177, 0.10525, 0.64767) @ sm.SE3.Ry(np.pi)
T1 = sm.SE3(0.36177, -0.22975, 0.3162) @ sm.SE3.Ry(np.pi/2)

# Cartesian trapezoidal velocity trajectory
t = np.arange(0, 2, dt)
T_trap = rtb.tools.trajectory.ctraj(T0, T1, t)
v0, theta0 = sm.base.tr2angvec(T0.R)
rtde_c.moveL(T0.t.tolist() + (v0*theta0).tolist())
for T_i in T_trap:
    t_start = rtde_c.initPeriod()
    v_i, theta_i = sm.base.tr2angvec(T_i.R)
    p_i = T_i.t.tolist() + (v_i * theta_i).tolist()
    rtde_c.servoL(p_i, 0.0, 0.0, dt, lookahead_time, gain)
    rtde_c.waitPeriod(t_start)
rtde_c.servoStop()
