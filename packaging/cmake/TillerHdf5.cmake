# SPDX-License-Identifier: MIT
# Defines TillerHdf5::hdf5 if the HDF5 library is installed. Used by the build and by the installed package.
# find_package(HDF5) is not used, because it needs a C compiler.
find_path(TILLER_HDF5_INCLUDE hdf5.h PATH_SUFFIXES hdf5/serial)
find_library(TILLER_HDF5_LIBRARY NAMES hdf5_serial hdf5)
mark_as_advanced(TILLER_HDF5_INCLUDE TILLER_HDF5_LIBRARY)
if(TILLER_HDF5_INCLUDE AND TILLER_HDF5_LIBRARY AND NOT TARGET TillerHdf5::hdf5)
    add_library(TillerHdf5::hdf5 UNKNOWN IMPORTED)
    set_target_properties(TillerHdf5::hdf5 PROPERTIES IMPORTED_LOCATION ${TILLER_HDF5_LIBRARY}
        INTERFACE_INCLUDE_DIRECTORIES ${TILLER_HDF5_INCLUDE})
endif()
