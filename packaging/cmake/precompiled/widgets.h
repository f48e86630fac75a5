// SPDX-License-Identifier: MIT
// Precompiled header of widgets/ and app/. It only speeds up the build. Each source file still includes all
// headers that it uses; a build with TILLER_PRECOMPILE=OFF checks this.
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
