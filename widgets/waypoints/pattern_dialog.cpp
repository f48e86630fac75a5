// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/waypoints/pattern_dialog.h"

#include <QDialogButtonBox>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

#include "robot/project/relative_move.h"
#include "robot/station/document/project_document.h"
#include "robot/station/text/notation.h"
#include "widgets/common/choice_box.h"
#include "widgets/common/decimal_spin_box.h"
#include "widgets/waypoints/pattern_grid.h"

namespace tiller {
namespace {

constexpr double kMinSide = 0.001;  ///< minimum distance between two corners [m]

class CountBox : public QSpinBox {
public:
    CountBox(const char* name, const QString& spoken, int now) {
        setObjectName(QLatin1String(name));
        setAccessibleName(spoken);
        setRange(1, project::kMaxPatternSteps);
        setValue(now);
    }

protected:
    void wheelEvent(QWheelEvent* event) override { event->ignore(); }
};

}  // namespace

PatternDialog::PatternDialog(const ProjectDocument& document, const QVector<QUuid>& corners, QWidget* parent)
    : QDialog(parent), document_(document), isNew_(true) {
    pattern_.id = QUuid::createUuid();
    pattern_.name = document.patterns().nextName(tr("pattern"));
    pattern_.columns = 3;
    pattern_.rows = 3;
    for (std::size_t i = 0; i < 3; ++i) {
        pattern_.corners[i] = corners.value(static_cast<int>(i));
    }
    build(true);
    for (int i = 0; i < 3; ++i) {
        takeCorner(i);
    }
    refresh();
}

PatternDialog::PatternDialog(const ProjectDocument& document, const project::Pattern& pattern,
                             QWidget* parent)
    : QDialog(parent), document_(document), pattern_(pattern), isNew_(false) {
    build(false);
    refresh();
}

void PatternDialog::build(bool isNew) {
    setObjectName(QStringLiteral("pattern"));
    setWindowTitle(isNew ? tr("Pattern from three corners") : tr("Pattern “%1”").arg(pattern_.name));
    auto* form = new QGridLayout;
    const auto add = [&](const QString& text, QWidget* widget) {
        const int row = form->rowCount();
        auto* label = new QLabel(text);
        label->setBuddy(widget);
        form->addWidget(label, row, 0);
        form->addWidget(widget, row, 1);
    };
    name_ = new QLineEdit(pattern_.name);
    name_->setObjectName(QStringLiteral("pattern.name"));
    add(tr("Name"), name_);
    const QString texts[] = {tr("First cell"), tr("End of the first row"), tr("Start of the last row")};
    static constexpr const char* kNames[] = {"pattern.corner.first", "pattern.corner.column",
                                             "pattern.corner.row"};
    for (int i = 0; i < 3; ++i) {
        const auto at = static_cast<std::size_t>(i);
        corners_[at] = new ChoiceBox;
        corners_[at]->setObjectName(QLatin1String(kNames[at]));
        corners_[at]->setAccessibleName(texts[i]);
        corners_[at]->addItem(isNew ? tr("Select a waypoint") : tr("As taught"), QUuid());
        for (const project::Waypoint& point : document_.waypoints()) {
            if (point.place.pattern != pattern_.id) {
                corners_[at]->addItem(point.name, point.id);
            }
        }
        corners_[at]->setCurrentIndex(std::max(0, corners_[at]->findData(pattern_.corners[at])));
        add(texts[i], corners_[at]);
        connect(corners_[at], &QComboBox::currentIndexChanged, this, [this, i] {
            takeCorner(i);
            refresh();
        });
    }
    columns_ = new CountBox("pattern.columns", tr("Cells per row"), pattern_.columns);
    rows_ = new CountBox("pattern.rows", tr("Rows"), pattern_.rows);
    layers_ = new CountBox("pattern.layers", tr("Layers"), pattern_.layers);
    add(tr("Cells per row"), columns_);
    add(tr("Rows"), rows_);
    add(tr("Layers"), layers_);
    layerStep_ = new DecimalSpinBox;
    layerStep_->setObjectName(QStringLiteral("pattern.layerStep"));
    layerStep_->setAccessibleName(tr("Layer height"));
    layerStep_->setToolTip(
        tr("Distance from one layer to the next, measured opposite to the tool direction."));
    const double perUnit = format::metresPerUnit();
    layerStep_->setRange(-10 / perUnit, 10 / perUnit);
    layerStep_->setSuffix(QLatin1Char(' ') + format::lengthUnit());
    layerStep_->setValue(pattern_.layerStep / perUnit);
    add(tr("Layer height"), layerStep_);
    order_ = new ChoiceBox;
    order_->setObjectName(QStringLiteral("pattern.order"));
    order_->setAccessibleName(tr("Order"));
    order_->addItems({tr("Row by row"), tr("Zigzag")});
    order_->setCurrentIndex(static_cast<int>(pattern_.order));
    add(tr("Order"), order_);

    grid_ = new PatternGrid;
    feedback_ = new QLabel;
    feedback_->setObjectName(QStringLiteral("pattern.feedback"));
    feedback_->setWordWrap(true);
    feedback_->setMinimumHeight(3 * fontMetrics().height());
    feedback_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    buttons->button(QDialogButtonBox::Ok)->setText(isNew ? tr("Create pattern") : tr("Apply"));
    buttons->button(QDialogButtonBox::Ok)->setObjectName(QStringLiteral("pattern.accept"));
    connect(buttons, &QDialogButtonBox::accepted, this, &PatternDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* upper = new QHBoxLayout;
    upper->setSpacing(16);
    upper->addLayout(form);
    upper->addWidget(grid_, 1);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(upper);
    layout->addWidget(feedback_);
    layout->addWidget(buttons);

    connect(name_, &QLineEdit::textChanged, this, &PatternDialog::refresh);
    for (QSpinBox* box : {columns_, rows_, layers_}) {
        connect(box, &QSpinBox::valueChanged, this, &PatternDialog::refresh);
    }
    connect(layerStep_, &QDoubleSpinBox::valueChanged, this, &PatternDialog::refresh);
    connect(order_, &QComboBox::currentIndexChanged, this, &PatternDialog::refresh);
    connect(grid_, &PatternGrid::excludedChanged, this, [this] {
        pattern_.excluded = grid_->excluded();
        refresh();
    });
}

void PatternDialog::takeCorner(int corner) {
    const auto at = static_cast<std::size_t>(corner);
    const QUuid id = corners_[at]->currentData().toUuid();
    const int row = document_.waypoints().indexOf(id);
    pattern_.corners[at] = id;
    if (row < 0) {
        return;
    }
    const project::Waypoint& point = document_.waypoints().at(row);
    const std::optional<Pose> place = project::placeOf(point, document_.robot(), document_.frames());
    if (!place) {
        return;
    }
    if (corner == 0) {
        const QUuid before = pattern_.first.frame;
        pattern_.first = project::taughtAt(point, point.joints, *place, point.tcpOffset, document_.frames())
                             .value_or(point);
        pattern_.first.priority = project::TargetKind::Pose;
        pattern_.first.history = {};
        pattern_.first.place = {};
        if (before != pattern_.first.frame) {
            takeCorner(1);
            takeCorner(2);
        }
        return;
    }
    const std::optional<Pose> frame = document_.frames().pose(pattern_.first.frame);
    (corner == 1 ? pattern_.columnEnd : pattern_.rowEnd) = frame.value_or(Pose()).inverse() * place->position;
}

QString PatternDialog::problem() const {
    if (name_->text().trimmed().isEmpty()) {
        return tr("Enter a name for the pattern.");
    }
    const project::Pattern* other = document_.patterns().findByName(name_->text().trimmed());
    if (other != nullptr && other->id != pattern_.id) {
        return tr("A pattern with this name already exists. Choose a different name.");
    }
    if (isNew_) {
        for (std::size_t i = 0; i < 3; ++i) {
            const bool needed = i == 0 || (i == 1 ? pattern_.columns > 1 : pattern_.rows > 1);
            if (needed && pattern_.corners[i].isNull()) {
                return tr("Teach the corners first, then select a waypoint for each corner.");
            }
        }
    }
    const Eigen::Vector3d& origin = pattern_.first.pose.position;
    if ((pattern_.columns > 1 && (pattern_.columnEnd - origin).norm() < kMinSide) ||
        (pattern_.rows > 1 && (pattern_.rowEnd - origin).norm() < kMinSide)) {
        return tr("Two corners are at the same position. Select a different waypoint for one of them.");
    }
    const Eigen::Vector3d alongRow = pattern_.columnEnd - origin;
    const Eigen::Vector3d acrossRows = pattern_.rowEnd - origin;
    if (pattern_.columns > 1 && pattern_.rows > 1 &&
        alongRow.cross(acrossRows).norm() < kMinSide * std::max(alongRow.norm(), acrossRows.norm())) {
        return tr("The three corners are on a straight line. Select a different waypoint for one of them.");
    }
    if (layerStep_->isRefused()) {
        return tr("The layer height is not a number or is out of range. Enter a different layer height.");
    }
    if (pattern_.layers > 1 && pattern_.layerStep == 0) {
        return tr("The layer height must not be 0. Enter a layer height.");
    }
    const qint64 places = qint64(pattern_.columns) * pattern_.rows * pattern_.layers;
    if (places > project::kMaxPatternPositions) {
        return tr("The pattern has %1 cells; the maximum is %2. Enter fewer cells per row, rows or layers.")
            .arg(places)
            .arg(project::kMaxPatternPositions);
    }
    return project::placesOf(pattern_).empty() ? tr("All cells are excluded. Click a cell to include it.")
                                               : QString();
}

void PatternDialog::refresh() {
    pattern_.name = name_->text().trimmed();
    pattern_.columns = columns_->value();
    pattern_.rows = rows_->value();
    pattern_.layers = layers_->value();
    pattern_.layerStep = layerStep_->value() * format::metresPerUnit();
    pattern_.order = static_cast<project::PatternOrder>(order_->currentIndex());
    layerStep_->setEnabled(pattern_.layers > 1);
    grid_->setPattern(pattern_);
    pattern_.excluded = grid_->excluded();
    const QString wrong = problem();
    findChild<QPushButton*>(QStringLiteral("pattern.accept"))->setEnabled(wrong.isEmpty());
    if (!wrong.isEmpty()) {
        feedback_->setText(wrong);
        return;
    }
    int far = 0;
    const auto points = project::waypointsOf(pattern_, document_.robot(), document_.frames());
    for (const project::Waypoint& point : points) {
        far += project::reach(document_.robot(), point, document_.frames()).ok() ? 0 : 1;
    }
    const QString count = tr("%n waypoints", nullptr, static_cast<int>(points.size()));
    feedback_->setText(far == 0 ? tr("%1, all within reach.").arg(count)
                                : tr("%1, %n out of reach and marked.", nullptr, far).arg(count));
}

void PatternDialog::accept() {
    refresh();
    if (problem().isEmpty()) {
        QDialog::accept();
    }
}

}  // namespace tiller

#include "moc_pattern_dialog.cpp"
