# Other simulators, MuJoCo and ODE: referees of tests and peers of benchmarks. Nothing that is installed links them.
# FCL, a library of collision detection: referee of slow tests; target murosimf_fcl where it was found.
# OpenCV: referee of cameras' lenses in slow tests; target murosimf_opencv where it was found.
# Target murosimf_peers exists where both, and EGL, were found; else tests/peers and what needs it in bench/ are left out.
if(NOT MUROSIMF_PEERS)
  return()
endif()
find_path(MUROSIMF_MUJOCO_INCLUDE mujoco/mujoco.h)
find_library(MUROSIMF_MUJOCO_LIBRARY mujoco)
find_path(MUROSIMF_ODE_INCLUDE ode/ode.h)
find_library(MUROSIMF_ODE_LIBRARY ode)
mark_as_advanced(MUROSIMF_MUJOCO_INCLUDE MUROSIMF_MUJOCO_LIBRARY MUROSIMF_ODE_INCLUDE MUROSIMF_ODE_LIBRARY)
find_path(MUROSIMF_EGL_INCLUDE EGL/eglext.h)  # MuJoCo's pictures, drawn in software without a display
find_library(MUROSIMF_EGL_LIBRARY EGL)
mark_as_advanced(MUROSIMF_EGL_INCLUDE MUROSIMF_EGL_LIBRARY)
if(MUROSIMF_EGL_INCLUDE AND MUROSIMF_EGL_LIBRARY AND MUROSIMF_MUJOCO_INCLUDE AND MUROSIMF_MUJOCO_LIBRARY AND MUROSIMF_ODE_INCLUDE AND MUROSIMF_ODE_LIBRARY)
  add_library(murosimf_peers INTERFACE)
  target_include_directories(murosimf_peers SYSTEM INTERFACE "${MUROSIMF_MUJOCO_INCLUDE}" "${MUROSIMF_ODE_INCLUDE}")
  target_link_libraries(murosimf_peers INTERFACE murosimf_scene murosimf_controllers "${MUROSIMF_MUJOCO_LIBRARY}" "${MUROSIMF_ODE_LIBRARY}"
    "${MUROSIMF_EGL_LIBRARY}")
endif()
find_package(fcl QUIET)
if(TARGET fcl)
  add_library(murosimf_fcl INTERFACE)
  target_link_libraries(murosimf_fcl INTERFACE fcl)
  # Debian builds FCL for any x86-64: Eigen's structures in its headers must not take AVX's alignment from our flags.
  target_compile_definitions(murosimf_fcl INTERFACE EIGEN_MAX_ALIGN_BYTES=16 EIGEN_MAX_STATIC_ALIGN_BYTES=16)
endif()
find_package(OpenCV QUIET COMPONENTS core imgproc calib3d)
if(OpenCV_FOUND)
  add_library(murosimf_opencv INTERFACE)
  target_link_libraries(murosimf_opencv INTERFACE opencv_core opencv_imgproc opencv_calib3d)
endif()
