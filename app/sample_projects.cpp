// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sample_projects.h"

#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "widgets/common/fit_to_contents.h"

namespace tiller::app {
namespace {

/// Translation context of this file for lupdate.
struct SampleText {
    Q_DECLARE_TR_FUNCTIONS(SampleProjects)
};

}  // namespace

QList<SampleProject> sampleProjects() {
    const auto path = [](const char* id) {
        return QStringLiteral(":/tiller/samples/%1.tiller").arg(QLatin1String(id));
    };
    return {{QStringLiteral("pick-and-place"), SampleText::tr("Pick and place"),
             SampleText::tr("Picks a part from a feeder and places it in one of six tray cells. The cells "
                            "are defined in the frame of the tray and move with it."),
             path("pick-and-place")},
            {QStringLiteral("gluing"), SampleText::tr("Gluing along a path"),
             SampleText::tr("Applies a bead around a lid with rounded corners in slow, straight moves. "
                            "Blends keep the nozzle moving through the corners."),
             path("gluing")},
            {QStringLiteral("measuring-round"), SampleText::tr("Measuring"),
             SampleText::tr("A probe touches a part from above and from four sides. Each touch starts at an "
                            "approach waypoint with the tool tilted."),
             path("measuring-round")}};
}

SampleDialog::SampleDialog(QWidget* parent) : QDialog(parent) {
    setObjectName(QStringLiteral("sampleDialog"));
    setWindowTitle(tr("Open sample project"));
    setAttribute(Qt::WA_DeleteOnClose);
    setMinimumWidth(560);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(24, 20, 24, 20);
    layout->setSpacing(14);
    auto* about = new QLabel(tr("Each project was taught with a UR5e and runs on the simulated robot. You "
                                "work on a copy. To keep your changes, save the project to a new file."),
                             this);
    about->setObjectName(QStringLiteral("sampleAbout"));
    about->setProperty("role", QStringLiteral("secondary"));
    about->setWordWrap(true);
    layout->addWidget(about);
    const QList<SampleProject> samples = sampleProjects();
    for (const SampleProject& sample : samples) {
        auto* title = new QLabel(sample.title, this);
        title->setProperty("role", QStringLiteral("strong"));
        auto* text = new QLabel(sample.text, this);
        text->setWordWrap(true);
        auto* words = new QVBoxLayout;
        words->setSpacing(2);
        words->addWidget(title);
        words->addWidget(text);
        auto* open = new QPushButton(tr("Open"), this);
        open->setObjectName(QStringLiteral("sample.") + sample.id);
        open->setAccessibleName(tr("Open “%1”").arg(sample.title));
        open->setAutoDefault(false);
        connect(open, &QPushButton::clicked, this, [this, sample] {
            accept();
            Q_EMIT chosen(sample.path, sample.title);
        });
        auto* row = new QHBoxLayout;
        row->setSpacing(16);
        row->addLayout(words, 1);
        row->addWidget(open, 0, Qt::AlignVCenter);
        layout->addLayout(row);
    }
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    layout->addWidget(buttons);
}

void SampleDialog::showEvent(QShowEvent* event) {
    QDialog::showEvent(event);
    fitToContents(*this);
}

}  // namespace tiller::app

#include "moc_sample_projects.cpp"
