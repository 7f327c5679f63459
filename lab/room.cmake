# What judges. lab/reference and lab/metrics need the pipeline alone; study and paper also JSON, which
# pipeline/room.cmake has found for the program.
caustics_add_room(reference lab/reference FAST)
caustics_add_room(metrics lab/metrics FAST)
target_link_libraries(caustics_reference PUBLIC caustics_pipeline)
target_link_libraries(caustics_metrics PUBLIC caustics_pipeline)
include(lab/reference/room.cmake)
if(CAUSTICS_BUILD_APP)
  caustics_add_room(study lab/study)
  caustics_add_room(paper lab/paper)
  target_link_libraries(caustics_study PUBLIC caustics_metrics nlohmann_json::nlohmann_json)
  target_link_libraries(caustics_paper PUBLIC caustics_reference nlohmann_json::nlohmann_json)
endif()
