// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The axis labels of a plot, as plain text items at fixed positions. With the axes of QChart, every change of
// a label, e.g. in each frame of a zoom, would update the layout of the whole chart.

#include <QColor>
#include <QFont>
#include <QGraphicsItem>
#include <QString>
#include <vector>

namespace tiller {

class AxisLabels : public QGraphicsItem {
public:
    struct Label {
        QRectF box;  ///< rectangle in chart coordinates
        QString text;
        friend bool operator==(const Label&, const Label&) = default;
    };

    /// alignment  alignment of each text in its box; right-aligned texts use a smaller font if they do not
    ///            fit
    AxisLabels(Qt::Alignment alignment, QGraphicsItem* parent);

    void setLook(const QFont& font, const QColor& color);
    void setLabels(std::vector<Label> labels);
    const std::vector<Label>& labels() const { return labels_; }
    const QFont& font() const { return font_; }

    QRectF boundingRect() const override { return bounds_; }
    void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override;

private:
    Qt::Alignment alignment_;
    QFont font_;
    QColor color_;
    std::vector<Label> labels_;
    QRectF bounds_;
};

}  // namespace tiller
