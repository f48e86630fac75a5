// SPDX-License-Identifier: MIT
// Parsed once for all of robot/: what is not ours, and the few headers of ours that nearly every file reads.
// A convenience of the build only: every file still names what it includes (TILLER_PRECOMPILE=OFF shows it).
// Only what many files include: each file pays for the inline functions of all that stands here. With <QtCore> and
// <QtWidgets> an empty file took 5 s of processor time.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <charconv>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <thread>
#include <unordered_map>
#include <utility>
#include <variant>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <QByteArray>
#include <QFile>
#include <QObject>
#include <QString>
#include <QStringList>
#include <QVector>

#include "robot/core/deadline.h"
#include "robot/core/joints.h"
#include "robot/core/modes.h"
#include "robot/core/result.h"
#include "robot/core/robot_model.h"
#include "robot/core/spatial.h"
#include "robot/core/version.h"
