// SPDX-License-Identifier: MIT
// Precompiled header of robot/: third-party headers, and the few headers of this project that nearly every
// file includes. It only speeds up the build. Each source file still includes all headers that it uses; a
// build with TILLER_PRECOMPILE=OFF checks this.
//
// Only headers that are used by many files are listed, because each source file also compiles their inline
// functions. With <QtCore> and <QtWidgets>, compiling an empty file took 5 s of processor time.
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
