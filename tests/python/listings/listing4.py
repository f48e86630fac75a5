# SPDX-License-Identifier: MIT
# Listing 4 of the ur_rtde paper.
from dmp import dmp_joint
import pandas as pd
from rtde_control import RTDEControlInterface

rtde_c = RTDEControlInterface(ip="localhost")

# Parameters
dt = 1.0/500 # 2ms
lookahead_time = 0.1
gain = 300

# Read Demonstration
demo = pd.read_csv("demonstration.csv")
q = demo[['actual_q_0', 'actual_q_1', 'actual_q_2', 'actual_q_3', 'actual_q_4', 'actual_q_5']]
time = demo['timestamp']-demo['timestamp'].iloc[0]
tau = time.iloc[-1]

# Train joint-space DMP
dmp_q = dmp_joint.JointDMP(n_bfs=100)
dmp_q.train(q.to_numpy(), time.to_numpy(), tau)

# Execute DMP
dmp_q.reset()
xi = dmp_q.cs.step(dt, tau)
q, dq, ddq = dmp_q.step(xi, dt, tau)
rtde_c.moveJ(q)
while xi > 1e-20:
    t_start = rtde_c.initPeriod()
    xi = dmp_q.cs.step(dt, tau)
    q, dq, ddq = dmp_q.step(xi, dt, tau)
    rtde_c.servoJ(q, 0.0, 0.0, dt, lookahead_time, gain)
    rtde_c.waitPeriod(t_start)
rtde_c.servoStop()
