// SPDX-License-Identifier: MIT
// Parsed once for widgets/ and app/.
// A convenience of the build only: every file still names what it includes (TILLER_PRECOMPILE=OFF shows it).
#pragma once

#include "packaging/cmake/precompiled/robot.h"

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QCoreApplication>
#include <QDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPainter>
#include <QPushButton>
#include <QTableView>
#include <QTimer>
#include <QVBoxLayout>
#include <QWidget>
