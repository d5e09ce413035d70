#pragma once
#include "core/scene/scene.h"

namespace rasterlens
{

// One function a built-in scene. Each fills mesh, space, lit, background, materials, textures and defaults.

// From the classroom texts: small, with exact numbers.
[[nodiscard]] Scene makeTriangle();
[[nodiscard]] Scene makeSquareDiagonal();
[[nodiscard]] Scene makeTriangle600();
[[nodiscard]] Scene makeGames101();
[[nodiscard]] Scene makeGames101Tilted();
[[nodiscard]] Scene makeTileSquare();
[[nodiscard]] Scene makeFan();
[[nodiscard]] Scene makeLines();

// Solids and surfaces.
[[nodiscard]] Scene makeCube();
[[nodiscard]] Scene makeSphere();
[[nodiscard]] Scene makeLetterF();
[[nodiscard]] Scene makeLeaf();
[[nodiscard]] Scene makeTorusKnot();
[[nodiscard]] Scene makeTeapot();
[[nodiscard]] Scene makeHead();

// What clipping is for.
[[nodiscard]] Scene makeFloor();
[[nodiscard]] Scene makeTunnel();
[[nodiscard]] Scene makeBehindCamera();
[[nodiscard]] Scene makeCovering();
[[nodiscard]] Scene makeEdgeGuardband();
[[nodiscard]] Scene makeSlivers();

// What the depth test is for.
[[nodiscard]] Scene makePainterCycle();
[[nodiscard]] Scene makePiercing();
[[nodiscard]] Scene makeZFighting();
[[nodiscard]] Scene makeDecal();
[[nodiscard]] Scene makeWireOverFill();
[[nodiscard]] Scene makeEqualPass();
[[nodiscard]] Scene makeBeamToEye();
[[nodiscard]] Scene makeLockstep();
[[nodiscard]] Scene makeFourZ();
[[nodiscard]] Scene makeCutOuts();

// Where mistakes show that the others forgive.
[[nodiscard]] Scene makeSquareCounted();
[[nodiscard]] Scene makeThinGap();
[[nodiscard]] Scene makeThreeLayers();
[[nodiscard]] Scene makeTwoWindings();
[[nodiscard]] Scene makeLineTies();
[[nodiscard]] Scene makeTinyTiles();
[[nodiscard]] Scene makeSamples();
[[nodiscard]] Scene makeZeroArea();
[[nodiscard]] Scene makeLongSliver();
[[nodiscard]] Scene makeHugeTriangle();
[[nodiscard]] Scene makeOverhang();
[[nodiscard]] Scene makeFlatEdge();
[[nodiscard]] Scene makeCutOnCentres();
[[nodiscard]] Scene makeBetweenRows();
[[nodiscard]] Scene makeSmallScreen();
[[nodiscard]] Scene makePointsOverBorder();
[[nodiscard]] Scene makeSignpost();
[[nodiscard]] Scene makeRoad();
[[nodiscard]] Scene makeSquashedBall();

// What textures and light are looked up with.
[[nodiscard]] Scene makePictureCard();
[[nodiscard]] Scene makeTexelsAboutZero();
[[nodiscard]] Scene makeDiscFloor();
[[nodiscard]] Scene makeCoarseBall();
[[nodiscard]] Scene makeMsaaSprite();
[[nodiscard]] Scene makeMsaaGradient();
[[nodiscard]] Scene makeMsaaSeams();

} // namespace rasterlens
