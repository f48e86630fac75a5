// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The numbers beside and under a plot. A chart's own axes lay the whole chart out anew for every label that comes or
// goes, which a zoom does in each frame; here they are texts at places, and nothing else.

#include <QColor>
#include <QFont>
#include <QGraphicsItem>
#include <QString>
#include <vector>

namespace tiller {

class AxisLabels : public QGraphicsItem {
public:
    struct Label {
        QRectF box;  ///< in the chart's coordinates
        QString text;
        friend bool operator==(const Label&, const Label&) = default;
    };

    /// alignment  of each text in its box
    AxisLabels(Qt::Alignment alignment, QGraphicsItem* parent);

    void setLook(const QFont& font, const QColor& color);
    void setLabels(std::vector<Label> labels);
    const std::vector<Label>& labels() const { return labels_; }

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
