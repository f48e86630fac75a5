// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The frames as rows. The name is edited in place (F2 or double click).

#include "widgets/common/row_table.h"

namespace tiller {

class FrameModel;

class FrameTable : public RowTable {
    Q_OBJECT

public:
    explicit FrameTable(FrameModel& model, QWidget* parent = nullptr);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void shareWidth();
};

}  // namespace tiller
