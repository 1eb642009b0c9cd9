# The messages of player_api.proto as classes, by Debian's protoc: code of others, compiled without our warnings.
set(murosimf_schema "${PROJECT_SOURCE_DIR}/src/murosimf/control/player_api/player_api.proto")
set(murosimf_generated "${PROJECT_BINARY_DIR}/generated")
set(murosimf_messages "${murosimf_generated}/murosimf/control/player_api/player_api.pb")
file(MAKE_DIRECTORY "${murosimf_generated}")
add_custom_command(OUTPUT "${murosimf_messages}.cc" "${murosimf_messages}.h"
  COMMAND protobuf::protoc "--cpp_out=${murosimf_generated}" -I "${PROJECT_SOURCE_DIR}/src" "${murosimf_schema}"
  DEPENDS "${murosimf_schema}" VERBATIM)
add_library(murosimf_player_api_messages STATIC "${murosimf_messages}.cc")
target_compile_options(murosimf_player_api_messages PRIVATE -w)
target_include_directories(murosimf_player_api_messages SYSTEM PUBLIC "$<BUILD_INTERFACE:${murosimf_generated}>")
target_link_libraries(murosimf_player_api_messages PUBLIC protobuf::libprotobuf)
set_target_properties(murosimf_player_api_messages PROPERTIES EXPORT_NAME player_api_messages)
set_property(GLOBAL APPEND PROPERTY murosimf_layers murosimf_player_api_messages)
