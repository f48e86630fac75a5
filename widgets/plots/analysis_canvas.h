// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A line plot without a time axis: a spectrum, or one signal plotted over another. Draws every point.

#include <QPointF>
#include <QVector>
#include <QWidget>

namespace tiller {

class AnalysisCanvas : public QWidget {
    Q_OBJECT

public:
    struct Axis {
        QString title;  ///< e.g. "Frequency [Hz]"
        double low = 0;
        double high = 1;
    };

    explicit AnalysisCanvas(QWidget* parent = nullptr);

    /// Scales both axes to fit the points.
    /// message  shown if there are no points
    void show(const QVector<QPointF>& points, const QString& xTitle, const QString& yTitle,
              const QString& message);
    const QVector<QPointF>& points() const { return points_; }
    const QString& message() const { return message_; }
    const Axis& xAxis() const { return x_; }
    const Axis& yAxis() const { return y_; }

    QSize sizeHint() const override { return {600, 200}; }
    QSize minimumSizeHint() const override { return {200, 90}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QRectF area() const;

    QVector<QPointF> points_;
    QString message_;
    Axis x_;
    Axis y_;
};

}  // namespace tiller
