# Real meshes, for what shapes of our own do not have: ORBWEAVER_MESHES. Whoever reads one says when it is missing.
find_path(ORBWEAVER_MESHES spot.obj PATHS ${PROJECT_SOURCE_DIR}/../shared/data/meshes
    ${PROJECT_SOURCE_DIR}/../../shared/data/meshes NO_DEFAULT_PATH)
