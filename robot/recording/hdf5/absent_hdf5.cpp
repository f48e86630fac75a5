// SPDX-License-Identifier: MIT
// Replaces the other files of this folder in a build without libhdf5.

#include "robot/recording/hdf5/episodes.h"
#include "robot/recording/hdf5/hdf5_export.h"
#include "robot/recording/hdf5/hdf5_recording.h"

namespace tiller::recording {

namespace {

QString libraryIsMissing() {
    return QStringLiteral("this program was built without libhdf5; use CSV or MCAP");
}

}  // namespace

Result<ExportReport> exportHdf5(const Recording&, const ExportChoice& choice) {
    return Error{ErrorCode::FileNotWritable, choice.path, libraryIsMissing()};
}

Result<std::unique_ptr<Recording>> openHdf5(const Text& path, const TableFormat&) {
    return Error{ErrorCode::FileNotReadable, path, libraryIsMissing()};
}

Result<std::vector<Episode>> findEpisodes(const Recording&, EpisodeChoice::Cut) {
    return Error{ErrorCode::FileNotReadable, QStringLiteral("find episodes"), libraryIsMissing()};
}

Result<EpisodeReport> writeEpisodes(const std::vector<const Recording*>&, const Text& path,
                                    const EpisodeChoice&) {
    return Error{ErrorCode::FileNotWritable, path, libraryIsMissing()};
}

}  // namespace tiller::recording
