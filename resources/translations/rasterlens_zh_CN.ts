<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
<context>
    <name>Applicability</name>
    <message>
        <source>Only filled triangles ask whether a pixel centre is inside.</source>
        <translation>只有实心填充的三角形才判断像素中心是否在内部。</translation>
    </message>
    <message>
        <source>Only filled triangles are covered by an algorithm.</source>
        <translation>只有实心填充的三角形才使用覆盖算法。</translation>
    </message>
    <message>
        <source>Only filled triangles share pixels at their edges.</source>
        <translation>只有实心填充的三角形才会在公共边上争夺像素。</translation>
    </message>
    <message>
        <source>Edge walking evaluates no edge functions.</source>
        <translation>边步进（扫描线）不计算边函数。</translation>
    </message>
    <message>
        <source>Lines are drawn by the wireframe only.</source>
        <translation>只有线框模式才画线。</translation>
    </message>
    <message>
        <source>Nothing is culled.</source>
        <translation>没有剔除任何面。</translation>
    </message>
    <message>
        <source>Only the z-buffer compares depths.</source>
        <translation>只有深度缓冲才比较深度。</translation>
    </message>
    <message>
        <source>Only the z-buffer stores depths.</source>
        <translation>只有深度缓冲才存储深度。</translation>
    </message>
    <message>
        <source>Every fragment passes the depth test.</source>
        <translation>所有片元都通过深度测试。</translation>
    </message>
    <message>
        <source>Only edge walking interpolates along edges and spans.</source>
        <translation>只有边步进才沿边、再沿扫描段插值。</translation>
    </message>
    <message>
        <source>This shading reads no interpolated attributes.</source>
        <translation>这种着色不读取插值属性。</translation>
    </message>
    <message>
        <source>Only texture shading reads texels.</source>
        <translation>只有纹理着色才读取纹素。</translation>
    </message>
    <message>
        <source>Only the tiled algorithm uses threads.</source>
        <translation>只有分块算法使用多线程。</translation>
    </message>
    <message>
        <source>Only the tiled algorithm uses vector instructions.</source>
        <translation>只有分块算法使用向量指令。</translation>
    </message>
    <message>
        <source>on</source>
        <translation>开</translation>
    </message>
    <message>
        <source>off</source>
        <translation>关</translation>
    </message>
</context>
<context>
    <name>BuiltinScene</name>
    <message>
        <source>Triangle</source>
        <translation>三角形</translation>
    </message>
    <message>
        <source>One triangle with a red, a green and a blue corner.</source>
        <translation>一个三角形，三个顶点分别为红、绿、蓝。</translation>
    </message>
    <message>
        <source>Square cut by its diagonal</source>
        <translation>被对角线切开的正方形</translation>
    </message>
    <message>
        <source>The diagonal runs through the centres of 8 pixels. Each of them must belong to one triangle, not to both and not to none.</source>
        <translation>对角线正好穿过 8 个像素的中心。每个像素必须恰好属于一个三角形，既不能重复，也不能遗漏。</translation>
    </message>
    <message>
        <source>Triangle on 600 x 600</source>
        <translation>600 × 600 上的三角形</translation>
    </message>
    <message>
        <source>The corners (100, 200), (300, 400) and (400, 100), with y counted upwards as in tinyrenderer. On the screen, where y runs down, they are (100, 400), (300, 200) and (400, 500); the order is clockwise.</source>
        <translation>顶点 (100, 200)、(300, 400)、(400, 100)，与 tinyrenderer 一样 y 轴向上。屏幕上 y 轴向下，因此是 (100, 400)、(300, 200)、(400, 500)，环绕方向为顺时针。</translation>
    </message>
    <message>
        <source>GAMES101: two triangles</source>
        <translation>GAMES101：两个三角形</translation>
    </message>
    <message>
        <source>The front triangle is sent first. Without a depth test the back one is painted over it.</source>
        <translation>前面的三角形先提交。没有深度测试时，后面的三角形会画在它上面。</translation>
    </message>
    <message>
        <source>4 x 4 tiles in perspective</source>
        <translation>透视下的 4 × 4 瓷砖</translation>
    </message>
    <message>
        <source>Two triangles. With affine interpolation the tiles and the white middle line break at the diagonal.</source>
        <translation>两个三角形。使用仿射插值时，瓷砖和白色中线会在对角线处折断。</translation>
    </message>
    <message>
        <source>Head with an open mouth</source>
        <translation>张嘴的头像</translation>
    </message>
    <message>
        <source>Faces are sent from the front to the back. Without the depth test the cavity behind the lips shows through, although back faces are culled.</source>
        <translation>面按从前到后的顺序提交。没有深度测试时，即使剔除了背面，嘴唇后面的口腔也会透出来。</translation>
    </message>
    <message>
        <source>Utah teapot</source>
        <translation>犹他茶壶</translation>
    </message>
    <message>
        <source>32 Bezier patches. The published model is open between lid and body and at the spout, so back faces are kept.</source>
        <translation>32 个贝塞尔曲面片。公开的模型在壶盖与壶身之间以及壶嘴处是开口的，所以保留背面。</translation>
    </message>
    <message>
        <source>Torus knot</source>
        <translation>环面纽结</translation>
    </message>
    <message>
        <source>A closed surface that hides itself many times.</source>
        <translation>一个多次遮挡自身的封闭曲面。</translation>
    </message>
    <message>
        <source>Floor to the horizon</source>
        <translation>延伸到地平线的地面</translation>
    </message>
    <message>
        <source>The floor passes under and behind the camera. Without near clipping the foreground is lost; with the depth test off as well, what lies behind hangs upside down in the sky.</source>
        <translation>地面从摄像机下方一直延伸到身后。不做近平面裁剪会丢失前景；如果深度测试也关闭，身后的部分会上下颠倒地悬在空中。</translation>
    </message>
    <message>
        <source>Letter F</source>
        <translation>字母 F</translation>
    </message>
    <message>
        <source>Orange in front, blue at the back. An F shows every flip, and every mistake of winding.</source>
        <translation>正面橙色，背面蓝色。字母 F 能显示每一种翻转和每一个环绕方向错误。</translation>
    </message>
    <message>
        <source>Leaf</source>
        <translation>叶片</translation>
    </message>
    <message>
        <source>An open surface: where the leaf turns its back, back-face culling tears a hole into it. Turn culling off.</source>
        <translation>开放曲面：叶片背对我们的地方会被背面剔除挖出空洞。请关闭剔除。</translation>
    </message>
    <message>
        <source>Fan</source>
        <translation>扇形</translation>
    </message>
    <message>
        <source>16 triangles meet at the centre of the middle pixel. Under the top-left rule exactly one of them owns it.</source>
        <translation>16 个三角形在中间像素的中心相接。按左上规则，恰好只有一个三角形拥有它。</translation>
    </message>
    <message>
        <source>Tunnel through the camera</source>
        <translation>穿过摄像机的隧道</translation>
    </message>
    <message>
        <source>The tube starts behind the camera: its first rings lie behind the eye or cross its plane, where w is 0.</source>
        <translation>管道从摄像机后面开始：前几圈在眼睛后面，或穿过 w 为 0 的平面。</translation>
    </message>
    <message>
        <source>Cube</source>
        <translation>立方体</translation>
    </message>
    <message>
        <source>Closed and convex, one colour a face. Culling alone hides what is hidden.</source>
        <translation>封闭的凸体，每个面一种颜色。只靠剔除就能隐藏被遮挡的部分。</translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation>球体</translation>
    </message>
    <message>
        <source>Closed and convex, with smooth normals. Compare flat, Gouraud and Phong shading.</source>
        <translation>封闭的凸体，法线平滑。请比较平面着色、Gouraud 着色和 Phong 着色。</translation>
    </message>
    <message>
        <source>Three blades in a circle</source>
        <translation>首尾相压的三片叶片</translation>
    </message>
    <message>
        <source>Each lies over the next, so no order of painting is right. The depth test decides pixel by pixel.</source>
        <translation>每一片都压在下一片上，因此没有正确的绘制顺序。深度测试逐像素地决定。</translation>
    </message>
    <message>
        <source>Two triangles that pierce each other</source>
        <translation>互相穿插的两个三角形</translation>
    </message>
    <message>
        <source>Each is in front in one half. The painter&apos;s algorithm shows one of them whole.</source>
        <translation>每个三角形各有一半在前面。画家算法会把其中一个完整地显示出来。</translation>
    </message>
    <message>
        <source>Z-fighting</source>
        <translation>深度冲突（Z-fighting）</translation>
    </message>
    <message>
        <source>The orange panel is in front everywhere. The near plane is so close that depth cannot tell it from the wall.</source>
        <translation>橙色面板处处在前面。近平面太近，深度值无法把它和墙面区分开。</translation>
    </message>
    <message>
        <source>Sheaf of needles</source>
        <translation>一束细针</translation>
    </message>
    <message>
        <source>Triangles thinner than a pixel: most centres fall between them. Try more samples.</source>
        <translation>比一个像素还细的三角形：多数像素中心落在它们之间。请增加采样数。</translation>
    </message>
    <message>
        <source>A corner behind the camera</source>
        <translation>摄像机后面的顶点</translation>
    </message>
    <message>
        <source>The green corner lies behind the eye. The division by its negative w turns the triangle inside out unless it is clipped first.</source>
        <translation>绿色顶点在眼睛后面。如果不先裁剪，除以负的 w 会把三角形翻转。</translation>
    </message>
    <message>
        <source>Larger than the screen</source>
        <translation>比屏幕还大</translation>
    </message>
    <message>
        <source>All corners of the large triangle lie outside, yet it covers the screen. Rejecting faces without a corner inside loses it.</source>
        <translation>大三角形的所有顶点都在屏幕外，但它覆盖了整个屏幕。按“没有顶点在内部就丢弃”的做法会丢掉它。</translation>
    </message>
    <message>
        <source>Blades over the border</source>
        <translation>越过边界的叶片</translation>
    </message>
    <message>
        <source>They leave the screen on all sides, every third beyond the guard band. Compare how many faces are clipped.</source>
        <translation>叶片从四面越出屏幕，每三片有一片超出保护带。请比较被裁剪的面数。</translation>
    </message>
    <message>
        <source>Lines in all directions</source>
        <translation>各个方向的直线</translation>
    </message>
    <message>
        <source>A star in wireframe: slopes 0, 1/3, 1 and 3 in all octants, from pixel centre to pixel centre.</source>
        <translation>线框星形：所有八分区内斜率为 0、1/3、1 和 3 的直线，从像素中心到像素中心。</translation>
    </message>
    <message>
        <source>Board for four z values</source>
        <translation>四个 z 值的木板</translation>
    </message>
    <message>
        <source>The board goes from distance 1 on the left to 10 on the right, the markers stand at thirds of the screen. In the middle z/w is 0.8938 and the distance 1.818: z/w is linear on the screen, the distance is not. Board and markers have equal colours at equal distances, unless interpolation is affine.</source>
        <translation>木板左端距离为 1，右端为 10，标记位于屏幕的三等分处。正中间 z/w 为 0.8938，距离为 1.818：z/w 在屏幕上是线性的，距离则不是。木板和标记在相同距离处颜色相同，除非使用仿射插值。</translation>
    </message>
</context>
<context>
    <name>ImageExport</name>
    <message>
        <source>%1 could not be written: %2</source>
        <translation>无法写入 %1：%2</translation>
    </message>
    <message>
        <source>the picture is empty or too large.</source>
        <translation>图像为空或过大。</translation>
    </message>
</context>
<context>
    <name>Lens</name>
    <message>
        <source>left</source>
        <translation>左边</translation>
    </message>
    <message>
        <source>top</source>
        <translation>上边</translation>
    </message>
    <message>
        <source>neither</source>
        <translation>非左上</translation>
    </message>
    <message>
        <source>tie</source>
        <translation>平局</translation>
    </message>
    <message>
        <source>ours</source>
        <translation>归本面</translation>
    </message>
    <message>
        <source>not ours</source>
        <translation>不归本面</translation>
    </message>
    <message>
        <source>sample (%1, %2)</source>
        <translation>采样 (%1, %2)</translation>
    </message>
    <message>
        <source>%1 per x, %2 per y</source>
        <translation>x 每步 %1，y 每步 %2</translation>
    </message>
    <message>
        <source>tie: %1, %2</source>
        <translation>平局: %1，%2</translation>
    </message>
</context>
<context>
    <name>Settings</name>
    <message>
        <source>Edge equation</source>
        <translation>边函数</translation>
    </message>
    <message>
        <source>Edge walking</source>
        <translation>边步进（扫描线）</translation>
    </message>
    <message>
        <source>Tiled (fast)</source>
        <translation>分块（快速）</translation>
    </message>
    <message>
        <source>Fixed point</source>
        <translation>定点数</translation>
    </message>
    <message>
        <source>Float, 32 bit</source>
        <translation>32 位浮点</translation>
    </message>
    <message>
        <source>Float, 64 bit</source>
        <translation>64 位浮点</translation>
    </message>
    <message>
        <source>Incremental</source>
        <translation>增量式</translation>
    </message>
    <message>
        <source>Direct</source>
        <translation>直接计算</translation>
    </message>
    <message>
        <source>Solid</source>
        <translation>实心</translation>
    </message>
    <message>
        <source>Wireframe</source>
        <translation>线框</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>点</translation>
    </message>
    <message>
        <source>Bresenham</source>
        <translation>Bresenham 算法</translation>
    </message>
    <message>
        <source>DDA</source>
        <translation>DDA 算法</translation>
    </message>
    <message>
        <source>Frustum, 6 planes</source>
        <translation>视锥体，6 个平面</translation>
    </message>
    <message>
        <source>Frustum, 7 planes</source>
        <translation>视锥体，7 个平面</translation>
    </message>
    <message>
        <source>Guard band</source>
        <translation>保护带</translation>
    </message>
    <message>
        <source>Any vertex inside</source>
        <translation>任一顶点在内部</translation>
    </message>
    <message>
        <source>Near / far reject</source>
        <translation>近/远整面丢弃</translation>
    </message>
    <message>
        <source>Cohen-Sutherland</source>
        <translation>Cohen-Sutherland 算法</translation>
    </message>
    <message>
        <source>None</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Back faces</source>
        <translation>背面</translation>
    </message>
    <message>
        <source>Front faces</source>
        <translation>正面</translation>
    </message>
    <message>
        <source>Counter-clockwise</source>
        <translation>逆时针</translation>
    </message>
    <message>
        <source>Clockwise</source>
        <translation>顺时针</translation>
    </message>
    <message>
        <source>Screen area</source>
        <translation>屏幕面积</translation>
    </message>
    <message>
        <source>Clip-space determinant</source>
        <translation>裁剪空间行列式</translation>
    </message>
    <message>
        <source>Normal against gaze</source>
        <translation>法线与视线</translation>
    </message>
    <message>
        <source>Less</source>
        <translation>小于</translation>
    </message>
    <message>
        <source>Less or equal</source>
        <translation>小于或等于</translation>
    </message>
    <message>
        <source>Greater</source>
        <translation>大于</translation>
    </message>
    <message>
        <source>Always</source>
        <translation>总是通过</translation>
    </message>
    <message>
        <source>24 bit</source>
        <translation>24 位</translation>
    </message>
    <message>
        <source>16 bit</source>
        <translation>16 位</translation>
    </message>
    <message>
        <source>Before shading</source>
        <translation>着色之前</translation>
    </message>
    <message>
        <source>After shading</source>
        <translation>着色之后</translation>
    </message>
    <message>
        <source>-w to w (OpenGL)</source>
        <translation>-w 到 w（OpenGL）</translation>
    </message>
    <message>
        <source>0 to w (Direct3D)</source>
        <translation>0 到 w（Direct3D）</translation>
    </message>
    <message>
        <source>Z-buffer</source>
        <translation>深度缓冲</translation>
    </message>
    <message>
        <source>Painter&apos;s algorithm</source>
        <translation>画家算法</translation>
    </message>
    <message>
        <source>Submission order</source>
        <translation>提交顺序</translation>
    </message>
    <message>
        <source>Perspective-correct</source>
        <translation>透视校正</translation>
    </message>
    <message>
        <source>Affine</source>
        <translation>仿射</translation>
    </message>
    <message>
        <source>Barycentric</source>
        <translation>重心坐标</translation>
    </message>
    <message>
        <source>Edge, then span</source>
        <translation>先沿边再沿段</translation>
    </message>
    <message>
        <source>Top-left</source>
        <translation>左上规则</translation>
    </message>
    <message>
        <source>All inclusive</source>
        <translation>边界全部包含</translation>
    </message>
    <message>
        <source>All exclusive</source>
        <translation>边界全部排除</translation>
    </message>
    <message>
        <source>1</source>
        <translation>1</translation>
    </message>
    <message>
        <source>2 x 2</source>
        <translation>2 × 2</translation>
    </message>
    <message>
        <source>3 x 3</source>
        <translation>3 × 3</translation>
    </message>
    <message>
        <source>4 x 4</source>
        <translation>4 × 4</translation>
    </message>
    <message>
        <source>Gouraud</source>
        <translation>Gouraud</translation>
    </message>
    <message>
        <source>Flat</source>
        <translation>平面着色</translation>
    </message>
    <message>
        <source>Random flat colour</source>
        <translation>随机单色</translation>
    </message>
    <message>
        <source>Texture</source>
        <translation>纹理</translation>
    </message>
    <message>
        <source>Phong</source>
        <translation>Phong</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>深度</translation>
    </message>
    <message>
        <source>Normals</source>
        <translation>法线</translation>
    </message>
    <message>
        <source>Texture coordinates</source>
        <translation>纹理坐标</translation>
    </message>
    <message>
        <source>Overdraw</source>
        <translation>重绘次数</translation>
    </message>
    <message>
        <source>Triangle id</source>
        <translation>三角形编号</translation>
    </message>
    <message>
        <source>Nearest</source>
        <translation>最近邻</translation>
    </message>
    <message>
        <source>Bilinear</source>
        <translation>双线性</translation>
    </message>
    <message>
        <source>Best available</source>
        <translation>最佳可用</translation>
    </message>
    <message>
        <source>Scalar</source>
        <translation>标量</translation>
    </message>
    <message>
        <source>Clipping</source>
        <translation>裁剪</translation>
    </message>
    <message>
        <source>What happens to triangles that leave the view volume.</source>
        <translation>如何处理超出视景体的三角形。</translation>
    </message>
    <message>
        <source>Depth range in clip space</source>
        <translation>裁剪空间的深度范围</translation>
    </message>
    <message>
        <source>The near plane is z = -w in OpenGL and z = 0 in Direct3D.</source>
        <translation>近平面在 OpenGL 中是 z = -w，在 Direct3D 中是 z = 0。</translation>
    </message>
    <message>
        <source>Reversed z</source>
        <translation>反向 z</translation>
    </message>
    <message>
        <source>The near plane maps to 1 and the far plane to 0, which spends float&apos;s precision where it is needed.</source>
        <translation>近平面映射到 1，远平面映射到 0，把浮点精度用在需要的地方。</translation>
    </message>
    <message>
        <source>Subpixel bits</source>
        <translation>亚像素位数</translation>
    </message>
    <message>
        <source>Screen vertices snap to 1/2^bits of a pixel before anything is drawn.</source>
        <translation>在绘制之前，屏幕顶点先对齐到 1/2^位数 像素。</translation>
    </message>
    <message>
        <source>Number type</source>
        <translation>数值类型</translation>
    </message>
    <message>
        <source>The numbers that decide which pixels are covered. Fixed point is exact.</source>
        <translation>决定覆盖哪些像素所用的数。定点数是精确的。</translation>
    </message>
    <message>
        <source>Culling</source>
        <translation>背面剔除</translation>
    </message>
    <message>
        <source>Which faces are not drawn.</source>
        <translation>哪些面不画。</translation>
    </message>
    <message>
        <source>Front faces wind</source>
        <translation>正面环绕方向</translation>
    </message>
    <message>
        <source>The order of the vertices of a face that looks at us, with y up.</source>
        <translation>朝向我们的面的顶点顺序（y 轴向上）。</translation>
    </message>
    <message>
        <source>Facing decided by</source>
        <translation>朝向判定依据</translation>
    </message>
    <message>
        <source>The sign that tells front from back: snapped screen area, det[x y w] before clipping, or the normal against the gaze.</source>
        <translation>用哪个符号区分正反面：对齐后的屏幕面积、裁剪前的 det[x y w]，或法线与视线的夹角。</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>填充</translation>
    </message>
    <message>
        <source>Whole triangles, their outlines, or their corners.</source>
        <translation>画整个三角形、轮廓或顶点。</translation>
    </message>
    <message>
        <source>Algorithm</source>
        <translation>光栅化算法</translation>
    </message>
    <message>
        <source>How the covered pixels of a triangle are found.</source>
        <translation>如何找出三角形覆盖的像素。</translation>
    </message>
    <message>
        <source>Stepping</source>
        <translation>步进方式</translation>
    </message>
    <message>
        <source>Add A per column and B per row, or evaluate the edge functions anew at every pixel.</source>
        <translation>每列加 A、每行加 B，或在每个像素重新计算边函数。</translation>
    </message>
    <message>
        <source>Tie rule</source>
        <translation>边界归属规则</translation>
    </message>
    <message>
        <source>Who owns a pixel centre that lies exactly on an edge.</source>
        <translation>正好落在边上的像素中心归谁。</translation>
    </message>
    <message>
        <source>Lines</source>
        <translation>直线</translation>
    </message>
    <message>
        <source>How the lines of the wireframe are drawn.</source>
        <translation>线框的直线怎么画。</translation>
    </message>
    <message>
        <source>Samples a pixel</source>
        <translation>每像素采样数</translation>
    </message>
    <message>
        <source>Super-sampling: every sample keeps its own colour and depth, and the box filter averages them.</source>
        <translation>超采样：每个采样点保存自己的颜色和深度，再用盒式滤波求平均。</translation>
    </message>
    <message>
        <source>Visibility</source>
        <translation>可见性</translation>
    </message>
    <message>
        <source>Who is in front: a depth for every pixel, faces sorted from far to near, or the order of the file.</source>
        <translation>谁在前面：每个像素保存深度、按从远到近排序，或按文件顺序。</translation>
    </message>
    <message>
        <source>Depth test</source>
        <translation>深度测试</translation>
    </message>
    <message>
        <source>A fragment is kept if its depth compares like this with the stored one.</source>
        <translation>片元深度与已存深度满足这个比较时才保留。</translation>
    </message>
    <message>
        <source>Depth format</source>
        <translation>深度格式</translation>
    </message>
    <message>
        <source>The numbers the depth buffer stores.</source>
        <translation>深度缓冲中存储的数。</translation>
    </message>
    <message>
        <source>Depth test happens</source>
        <translation>深度测试时机</translation>
    </message>
    <message>
        <source>Testing before shading spares the work for hidden fragments; the picture is the same.</source>
        <translation>在着色之前测试可以省去被遮挡片元的着色，图像不变。</translation>
    </message>
    <message>
        <source>Interpolation</source>
        <translation>插值</translation>
    </message>
    <message>
        <source>Attributes divided by w on the way, or straight across the screen.</source>
        <translation>属性先除以 w 再插值，或直接在屏幕上线性插值。</translation>
    </message>
    <message>
        <source>Attribute path</source>
        <translation>属性插值路径</translation>
    </message>
    <message>
        <source>Barycentric weights at every pixel, or along the edges first and then along the span (edge walking only).</source>
        <translation>在每个像素用重心坐标，或先沿边再沿扫描段（仅限边步进）。</translation>
    </message>
    <message>
        <source>Shading</source>
        <translation>着色</translation>
    </message>
    <message>
        <source>What colours a fragment.</source>
        <translation>片元的颜色由什么决定。</translation>
    </message>
    <message>
        <source>Texture filter</source>
        <translation>纹理过滤</translation>
    </message>
    <message>
        <source>The nearest texel, or a blend of the four around the point.</source>
        <translation>取最近的纹素，或混合周围四个纹素。</translation>
    </message>
    <message>
        <source>Threads</source>
        <translation>线程数</translation>
    </message>
    <message>
        <source>Threads of the tiled algorithm; 0 takes as many as the machine has.</source>
        <translation>分块算法的线程数；0 表示用满机器的所有线程。</translation>
    </message>
    <message>
        <source>Vector instructions</source>
        <translation>向量指令</translation>
    </message>
    <message>
        <source>The instruction set of the tiled algorithm.</source>
        <translation>分块算法使用的指令集。</translation>
    </message>
</context>
<context>
    <name>StatisticsPanel</name>
    <message>
        <source>Faces</source>
        <translation>面</translation>
    </message>
    <message>
        <source>submitted</source>
        <translation>提交</translation>
    </message>
    <message>
        <source>Triangles of the scene.</source>
        <translation>场景中的三角形。</translation>
    </message>
    <message>
        <source>rejected</source>
        <translation>整体丢弃</translation>
    </message>
    <message>
        <source>Wholly outside the view volume.</source>
        <translation>完全在视景体之外。</translation>
    </message>
    <message>
        <source>clipped</source>
        <translation>被裁剪</translation>
    </message>
    <message>
        <source>Cut by at least one plane.</source>
        <translation>至少被一个平面切割。</translation>
    </message>
    <message>
        <source>created by clipping</source>
        <translation>裁剪生成</translation>
    </message>
    <message>
        <source>Triangles drawn for the cut faces.</source>
        <translation>为被切割的面而画的三角形。</translation>
    </message>
    <message>
        <source>culled, back</source>
        <translation>剔除（背面）</translation>
    </message>
    <message>
        <source>Turned away from us.</source>
        <translation>背对我们。</translation>
    </message>
    <message>
        <source>culled, front</source>
        <translation>剔除（正面）</translation>
    </message>
    <message>
        <source>Turned towards us.</source>
        <translation>面向我们。</translation>
    </message>
    <message>
        <source>degenerate</source>
        <translation>退化</translation>
    </message>
    <message>
        <source>Without area after snapping.</source>
        <translation>对齐后面积为零。</translation>
    </message>
    <message>
        <source>not finite</source>
        <translation>非有限值</translation>
    </message>
    <message>
        <source>A corner is infinite or not a number.</source>
        <translation>某个顶点是无穷大或不是数。</translation>
    </message>
    <message>
        <source>rasterized</source>
        <translation>已光栅化</translation>
    </message>
    <message>
        <source>Faces that reached the pixels; a cut face counts once.</source>
        <translation>到达像素阶段的面；被切割的面只算一次。</translation>
    </message>
    <message>
        <source>Pixels</source>
        <translation>像素</translation>
    </message>
    <message>
        <source>tested</source>
        <translation>已测试</translation>
    </message>
    <message>
        <source>Positions at which coverage was decided.</source>
        <translation>判断过是否覆盖的位置。</translation>
    </message>
    <message>
        <source>covered</source>
        <translation>被覆盖</translation>
    </message>
    <message>
        <source>Fragments.</source>
        <translation>片元数。</translation>
    </message>
    <message>
        <source>depth passed</source>
        <translation>通过深度测试</translation>
    </message>
    <message>
        <source>Fragments that passed the depth test.</source>
        <translation>通过深度测试的片元。</translation>
    </message>
    <message>
        <source>depth failed</source>
        <translation>未通过深度测试</translation>
    </message>
    <message>
        <source>Fragments hidden behind what was there.</source>
        <translation>被已有内容遮挡的片元。</translation>
    </message>
    <message>
        <source>shaded</source>
        <translation>已着色</translation>
    </message>
    <message>
        <source>Fragments whose colour was computed.</source>
        <translation>计算过颜色的片元。</translation>
    </message>
    <message>
        <source>written</source>
        <translation>已写入</translation>
    </message>
    <message>
        <source>Fragments stored in the image.</source>
        <translation>存入图像的片元。</translation>
    </message>
    <message>
        <source>hit twice</source>
        <translation>重复覆盖</translation>
    </message>
    <message>
        <source>Hit by both faces at the edge they share: 0 under the top-left rule.</source>
        <translation>在公共边上被两个面同时覆盖：左上规则下为 0。</translation>
    </message>
    <message>
        <source>vertices</source>
        <translation>顶点</translation>
    </message>
    <message>
        <source>geometry</source>
        <translation>几何</translation>
    </message>
    <message>
        <source>rasterization</source>
        <translation>光栅化</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>整帧</translation>
    </message>
    <message>
        <source>Frames per second: counted while frames keep coming, else what the last frame&apos;s time allows.</source>
        <translation>每秒帧数：连续出帧时为实际计数，否则按上一帧的用时推算。</translation>
    </message>
    <message>
        <source>Milliseconds</source>
        <translation>毫秒</translation>
    </message>
</context>
<context>
    <name>StepListing</name>
    <message>
        <source>inside</source>
        <translation>在内</translation>
    </message>
    <message>
        <source>outside</source>
        <translation>在外</translation>
    </message>
    <message>
        <source>owned: %1 is a %2 edge</source>
        <translation>归本面：%1 是%2</translation>
    </message>
    <message>
        <source>not owned: %1 is a %2 edge</source>
        <translation>不归本面：%1 是%2</translation>
    </message>
    <message>
        <source>right or bottom</source>
        <translation>右边或下边</translation>
    </message>
    <message>
        <source>next x: %1 %2</source>
        <translation>下一个 x：%1 %2</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>通过</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>未通过</translation>
    </message>
    <message>
        <source>vertex</source>
        <translation>顶点</translation>
    </message>
    <message>
        <source>clip plane</source>
        <translation>裁剪平面</translation>
    </message>
    <message>
        <source>Cohen-Sutherland</source>
        <translation>Cohen-Sutherland 算法</translation>
    </message>
    <message>
        <source>viewport</source>
        <translation>视口</translation>
    </message>
    <message>
        <source>facing</source>
        <translation>朝向</translation>
    </message>
    <message>
        <source>fan</source>
        <translation>扇形</translation>
    </message>
    <message>
        <source>verdict</source>
        <translation>判定</translation>
    </message>
    <message>
        <source>triangle</source>
        <translation>三角形</translation>
    </message>
    <message>
        <source>setup</source>
        <translation>设置</translation>
    </message>
    <message>
        <source>corners by height</source>
        <translation>按高度排序顶点</translation>
    </message>
    <message>
        <source>span</source>
        <translation>跨度</translation>
    </message>
    <message>
        <source>sample</source>
        <translation>采样</translation>
    </message>
    <message>
        <source>line decision</source>
        <translation>直线判定</translation>
    </message>
    <message>
        <source>line sample</source>
        <translation>直线采样</translation>
    </message>
    <message>
        <source>depth test</source>
        <translation>深度测试</translation>
    </message>
    <message>
        <source>shade</source>
        <translation>着色</translation>
    </message>
    <message>
        <source>write</source>
        <translation>写入</translation>
    </message>
    <message>
        <source>end of the frame</source>
        <translation>帧结束</translation>
    </message>
    <message>
        <source>tie</source>
        <translation>平局</translation>
    </message>
    <message>
        <source>row %1</source>
        <translation>第 %1 行</translation>
    </message>
    <message>
        <source>face %1</source>
        <translation>面 %1</translation>
    </message>
</context>
<context>
    <name>StressScene</name>
    <message>
        <source>1,000,000 triangles of 1 to 4 pixels</source>
        <translation>1,000,000 个 1 到 4 像素的三角形</translation>
    </message>
    <message>
        <source>100,000 triangles of 100 pixels</source>
        <translation>100,000 个 100 像素的三角形</translation>
    </message>
    <message>
        <source>2,000 triangles of 20,000 pixels</source>
        <translation>2,000 个 20,000 像素的三角形</translation>
    </message>
    <message>
        <source>10 full-screen quads, nearest first</source>
        <translation>10 个全屏四边形，由近到远</translation>
    </message>
    <message>
        <source>10 full-screen quads, farthest first</source>
        <translation>10 个全屏四边形，由远到近</translation>
    </message>
</context>
<context>
    <name>rasterlens::FieldRow</name>
    <message>
        <source>The scene asks for: %1. Click to put it back.</source>
        <translation>场景要求的值：%1。单击即可恢复。</translation>
    </message>
    <message>
        <source>No effect now: %1</source>
        <translation>现在不起作用：%1</translation>
    </message>
    <message>
        <source>Key %1 steps through the values.</source>
        <translation>按 %1 键切换取值。</translation>
    </message>
</context>
<context>
    <name>rasterlens::MainWindow</name>
    <message>
        <source>opening %1 …</source>
        <translation>正在打开 %1 …</translation>
    </message>
    <message>
        <source>drawing …</source>
        <translation>正在绘制 …</translation>
    </message>
    <message>
        <source>These settings cannot be drawn together: %1</source>
        <translation>这些设置不能一起使用：%1</translation>
    </message>
    <message>
        <source>pixel (%1, %2)</source>
        <translation>像素 (%1, %2)</translation>
    </message>
    <message>
        <source>face %1</source>
        <translation>面 %1</translation>
    </message>
    <message>
        <source>background</source>
        <translation>背景</translation>
    </message>
    <message>
        <source>depth %1</source>
        <translation>深度 %1</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no pixel of the picture. Write x, y with 0 to %2 and 0 to %3.</source>
        <translation>“%1”不是图像中的像素。请输入 x, y，范围为 0 到 %2 和 0 到 %3。</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>已写入：%1</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>文件(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>打开(&amp;O)…</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>最近打开的文件(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Built-in scenes</source>
        <translation>内置场景(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Save session</source>
        <translation>保存会话(&amp;S)</translation>
    </message>
    <message>
        <source>Save session &amp;as…</source>
        <translation>会话另存为(&amp;A)…</translation>
    </message>
    <message>
        <source>Export &amp;figure…</source>
        <translation>导出插图(&amp;F)…</translation>
    </message>
    <message>
        <source>Export figure</source>
        <translation>导出插图</translation>
    </message>
    <message>
        <source>Figure s&amp;cale</source>
        <translation>插图比例(&amp;C)</translation>
    </message>
    <message>
        <source>As on the screen</source>
        <translation>与屏幕相同</translation>
    </message>
    <message>
        <source>Export frame&amp;buffer 1:1…</source>
        <translation>导出帧缓冲 1:1(&amp;B)…</translation>
    </message>
    <message>
        <source>Export framebuffer</source>
        <translation>导出帧缓冲</translation>
    </message>
    <message>
        <source>Export &amp;window…</source>
        <translation>导出窗口(&amp;W)…</translation>
    </message>
    <message>
        <source>Export window</source>
        <translation>导出窗口</translation>
    </message>
    <message>
        <source>Copy &amp;image</source>
        <translation>复制图像(&amp;I)</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>退出(&amp;Q)</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>编辑(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>撤销(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>重做(&amp;R)</translation>
    </message>
    <message>
        <source>Reset &amp;settings</source>
        <translation>恢复设置(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>视图(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation>适合窗口(&amp;F)</translation>
    </message>
    <message>
        <source>1:1</source>
        <translation>1:1</translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation>放大</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>缩小</translation>
    </message>
    <message>
        <source>&amp;Go to pixel</source>
        <translation>转到像素(&amp;G)</translation>
    </message>
    <message>
        <source>From the front</source>
        <translation>前视图</translation>
    </message>
    <message>
        <source>From the right</source>
        <translation>右视图</translation>
    </message>
    <message>
        <source>From above</source>
        <translation>俯视图</translation>
    </message>
    <message>
        <source>Reset camera</source>
        <translation>重置摄像机</translation>
    </message>
    <message>
        <source>Pixel grid (from 8×)</source>
        <translation>像素网格（8× 起）</translation>
    </message>
    <message>
        <source>Sample positions (from 16×)</source>
        <translation>采样位置（16× 起）</translation>
    </message>
    <message>
        <source>Pixel values (from 48×)</source>
        <translation>像素数值（48× 起）</translation>
    </message>
    <message>
        <source>Draw continuously (measures FPS)</source>
        <translation>连续绘制（测量 FPS）</translation>
    </message>
    <message>
        <source>&amp;Panels</source>
        <translation>面板(&amp;P)</translation>
    </message>
    <message>
        <source>Reset &amp;layout</source>
        <translation>恢复默认布局(&amp;L)</translation>
    </message>
    <message>
        <source>P&amp;resentation</source>
        <translation>演示模式(&amp;R)</translation>
    </message>
    <message>
        <source>Full s&amp;creen</source>
        <translation>全屏(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Dark theme</source>
        <translation>深色主题(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Settings</source>
        <translation>设置(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>帮助(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Keys and their states</source>
        <translation>按键与当前状态(&amp;K)</translation>
    </message>
    <message>
        <source>&amp;About RasterLens</source>
        <translation>关于 RasterLens(&amp;A)</translation>
    </message>
    <message>
        <source>RasterLens %1 shows how a triangle becomes pixels.</source>
        <translation>RasterLens %1 展示三角形如何变成像素。</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>场景</translation>
    </message>
    <message>
        <source>Statistics</source>
        <translation>统计</translation>
    </message>
    <message>
        <source>Scene and pipeline</source>
        <translation>场景与管线</translation>
    </message>
    <message>
        <source>Copy the counters as CSV</source>
        <translation>把计数复制为 CSV</translation>
    </message>
    <message>
        <source>Copy the counters as JSON</source>
        <translation>把计数复制为 JSON</translation>
    </message>
    <message>
        <source>Go to pixel (%1)</source>
        <translation>转到像素 (%1)</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>清除</translation>
    </message>
    <message>
        <source>Pipeline</source>
        <translation>管线</translation>
    </message>
    <message>
        <source>Canvas</source>
        <translation>画布</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>滚轮</translation>
    </message>
    <message>
        <source>zoom at the cursor</source>
        <translation>以光标为中心缩放</translation>
    </message>
    <message>
        <source>Middle drag, Shift + drag</source>
        <translation>中键拖动，Shift + 拖动</translation>
    </message>
    <message>
        <source>move the picture</source>
        <translation>移动画面</translation>
    </message>
    <message>
        <source>Click, arrows</source>
        <translation>单击，方向键</translation>
    </message>
    <message>
        <source>choose a pixel, move on by one</source>
        <translation>选择像素，逐个移动</translation>
    </message>
    <message>
        <source>Double click</source>
        <translation>双击</translation>
    </message>
    <message>
        <source>close up of a pixel</source>
        <translation>放大到像素</translation>
    </message>
    <message>
        <source>fit</source>
        <translation>适合窗口</translation>
    </message>
    <message>
        <source>one to one</source>
        <translation>一比一</translation>
    </message>
    <message>
        <source>go to pixel</source>
        <translation>转到像素</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>摄像机</translation>
    </message>
    <message>
        <source>Drag</source>
        <translation>拖动</translation>
    </message>
    <message>
        <source>orbit</source>
        <translation>环绕</translation>
    </message>
    <message>
        <source>Right drag, Ctrl + wheel</source>
        <translation>右键拖动，Ctrl + 滚轮</translation>
    </message>
    <message>
        <source>nearer, farther</source>
        <translation>拉近、拉远</translation>
    </message>
    <message>
        <source>Ctrl + drag</source>
        <translation>Ctrl + 拖动</translation>
    </message>
    <message>
        <source>move the scene</source>
        <translation>移动场景</translation>
    </message>
    <message>
        <source>front, right, above</source>
        <translation>前、右、上视图</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Home</translation>
    </message>
    <message>
        <source>reset camera</source>
        <translation>重置摄像机</translation>
    </message>
    <message>
        <source>on</source>
        <translation>开</translation>
    </message>
    <message>
        <source>off</source>
        <translation>关</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>窗口</translation>
    </message>
    <message>
        <source>presentation</source>
        <translation>演示模式</translation>
    </message>
    <message>
        <source>dark theme</source>
        <translation>深色主题</translation>
    </message>
    <message>
        <source>draw continuously</source>
        <translation>连续绘制</translation>
    </message>
    <message>
        <source>reset layout</source>
        <translation>恢复默认布局</translation>
    </message>
    <message>
        <source>undo, redo</source>
        <translation>撤销、重做</translation>
    </message>
    <message>
        <source>figure with overlay</source>
        <translation>带叠加层的插图</translation>
    </message>
    <message>
        <source>framebuffer 1:1</source>
        <translation>帧缓冲 1:1</translation>
    </message>
    <message>
        <source>whole window</source>
        <translation>整个窗口</translation>
    </message>
    <message>
        <source>this list</source>
        <translation>本列表</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>打开</translation>
    </message>
    <message>
        <source>Scenes, cases and sessions (*.obj *.case *.json)</source>
        <translation>场景、用例与会话 (*.obj *.case *.json)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>所有文件 (*)</translation>
    </message>
    <message>
        <source>Save session</source>
        <translation>保存会话</translation>
    </message>
    <message>
        <source>Sessions (*.json)</source>
        <translation>会话 (*.json)</translation>
    </message>
    <message>
        <source>PNG images (*.png)</source>
        <translation>PNG 图像 (*.png)</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>适合窗口</translation>
    </message>
    <message>
        <source>Export figure as S&amp;VG…</source>
        <translation>导出插图为 SVG(&amp;V)…</translation>
    </message>
    <message>
        <source>Export figure as SVG</source>
        <translation>导出插图为 SVG</translation>
    </message>
    <message>
        <source>Export a &amp;run of steps…</source>
        <translation>导出一段步骤(&amp;R)…</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>步骤</translation>
    </message>
    <message>
        <source>record steps</source>
        <translation>记录步骤</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>空格</translation>
    </message>
    <message>
        <source>play, pause</source>
        <translation>播放、暂停</translation>
    </message>
    <message>
        <source>Left, Right</source>
        <translation>左、右</translation>
    </message>
    <message>
        <source>one step</source>
        <translation>一步</translation>
    </message>
    <message>
        <source>Shift + Left, Right</source>
        <translation>Shift + 左、右</translation>
    </message>
    <message>
        <source>one row</source>
        <translation>一行</translation>
    </message>
    <message>
        <source>Ctrl + Left, Right</source>
        <translation>Ctrl + 左、右</translation>
    </message>
    <message>
        <source>one face</source>
        <translation>一个面</translation>
    </message>
    <message>
        <source>Ctrl + Shift + Left, Right</source>
        <translation>Ctrl + Shift + 左、右</translation>
    </message>
    <message>
        <source>one stage</source>
        <translation>一个阶段</translation>
    </message>
    <message>
        <source>Ctrl + Home, End</source>
        <translation>Ctrl + Home、End</translation>
    </message>
    <message>
        <source>to the start, the end</source>
        <translation>到开头、结尾</translation>
    </message>
    <message>
        <source>slower, faster</source>
        <translation>更慢、更快</translation>
    </message>
    <message>
        <source>SVG drawings (*.svg)</source>
        <translation>SVG 图形 (*.svg)</translation>
    </message>
</context>
<context>
    <name>rasterlens::MessageBar</name>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>还有 %n 条</numerusform>
        </translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
</context>
<context>
    <name>rasterlens::PipelinePanel</name>
    <message>
        <source>&quot;%1&quot; is not a size. Write WIDTH x HEIGHT with 1 to %2 each.</source>
        <translation>“%1”不是尺寸。请输入 宽 x 高，各为 1 到 %2。</translation>
    </message>
    <message>
        <source>as the scene asks</source>
        <translation>与场景设定一致</translation>
    </message>
    <message numerus="yes">
        <source>%n changed · reset</source>
        <translation>
            <numerusform>已改 %n 项 · 恢复</numerusform>
        </translation>
    </message>
    <message>
        <source>Pipeline</source>
        <translation>管线</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>打开…</translation>
    </message>
    <message>
        <source>Put back every value to what the scene asks for</source>
        <translation>把所有值恢复为场景的设定</translation>
    </message>
    <message>
        <source>Size in pixels</source>
        <translation>图像尺寸（像素）</translation>
    </message>
    <message>
        <source>Width and height of the picture, 1 to %1 each. The window only magnifies it.</source>
        <translation>图像的宽和高，各为 1 到 %1。窗口只负责放大显示。</translation>
    </message>
</context>
<context>
    <name>rasterlens::RenderWorker</name>
    <message>
        <source>There is not enough memory for a picture of this size.</source>
        <translation>内存不足，无法绘制这么大的图像。</translation>
    </message>
</context>
<context>
    <name>rasterlens::StageStrip</name>
    <message>
        <source>Model</source>
        <translation>模型</translation>
    </message>
    <message>
        <source>Clip space</source>
        <translation>裁剪空间</translation>
    </message>
    <message>
        <source>Screen</source>
        <translation>屏幕</translation>
    </message>
    <message>
        <source>Cull</source>
        <translation>剔除</translation>
    </message>
    <message>
        <source>Cover</source>
        <translation>覆盖</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>深度</translation>
    </message>
    <message>
        <source>Shade</source>
        <translation>着色</translation>
    </message>
    <message>
        <source>Image</source>
        <translation>图像</translation>
    </message>
    <message>
        <source>1 face</source>
        <translation>1 个面</translation>
    </message>
    <message>
        <source>%1 faces</source>
        <translation>%1 个面</translation>
    </message>
    <message>
        <source>%1 cut</source>
        <translation>裁剪 %1</translation>
    </message>
    <message>
        <source>snapped 1/%1</source>
        <translation>对齐 1/%1</translation>
    </message>
    <message>
        <source>%1 culled</source>
        <translation>剔除 %1</translation>
    </message>
    <message>
        <source>%1 px</source>
        <translation>%1 像素</translation>
    </message>
    <message>
        <source>%1 samples</source>
        <translation>%1 采样</translation>
    </message>
    <message>
        <source>%1 pass</source>
        <translation>通过 %1</translation>
    </message>
    <message>
        <source>Clip</source>
        <comment>short for clip space</comment>
        <translation>裁剪</translation>
    </message>
</context>
<context>
    <name>rasterlens::StepMode</name>
    <message>
        <source>The record ends without another such event.</source>
        <translation>记录到结尾都没有这样的事件。</translation>
    </message>
    <message>
        <source>Nothing is recorded.</source>
        <translation>没有记录。</translation>
    </message>
    <message>
        <source>Export a run of steps</source>
        <translation>导出一段步骤</translation>
    </message>
    <message>
        <source>First and last step, for example 10-60:</source>
        <translation>起止步骤，例如 10-60：</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no run of steps 0 to %2.</source>
        <translation>“%1”不是 0 到 %2 之间的一段步骤。</translation>
    </message>
    <message>
        <source>Folder for the pictures</source>
        <translation>图像文件夹</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>已写入：%1</translation>
    </message>
</context>
<context>
    <name>rasterlens::StepSession</name>
    <message>
        <source>There is not enough memory to record this frame.</source>
        <translation>内存不足，无法记录这一帧。</translation>
    </message>
</context>
<context>
    <name>rasterlens::TransportDock</name>
    <message>
        <source>&amp;Record steps</source>
        <translation>记录步骤(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>播放(&amp;P)</translation>
    </message>
    <message>
        <source>Step &amp;back</source>
        <translation>后退一步(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Step</source>
        <translation>前进一步(&amp;S)</translation>
    </message>
    <message>
        <source>Row back</source>
        <translation>后退一行</translation>
    </message>
    <message>
        <source>Next ro&amp;w</source>
        <translation>下一行(&amp;W)</translation>
    </message>
    <message>
        <source>Face back</source>
        <translation>后退一个面</translation>
    </message>
    <message>
        <source>Next &amp;face</source>
        <translation>下一个面(&amp;F)</translation>
    </message>
    <message>
        <source>Stage back</source>
        <translation>后退一个阶段</translation>
    </message>
    <message>
        <source>Next s&amp;tage</source>
        <translation>下一个阶段(&amp;T)</translation>
    </message>
    <message>
        <source>To the st&amp;art</source>
        <translation>到开头(&amp;A)</translation>
    </message>
    <message>
        <source>To the &amp;end</source>
        <translation>到结尾(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Loop</source>
        <translation>循环(&amp;L)</translation>
    </message>
    <message>
        <source>Record &amp;what</source>
        <translation>记录范围(&amp;W)</translation>
    </message>
    <message>
        <source>The whole frame</source>
        <translation>整帧</translation>
    </message>
    <message>
        <source>The face at the selected pixel</source>
        <translation>选中像素处的面</translation>
    </message>
    <message>
        <source>What the canvas shows</source>
        <translation>画布显示的部分</translation>
    </message>
    <message>
        <source>Run &amp;until</source>
        <translation>运行到(&amp;U)</translation>
    </message>
    <message>
        <source>This &amp;pixel</source>
        <translation>此像素(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Sign change</source>
        <translation>符号改变(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Tie</source>
        <translation>平局(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Depth test fails</source>
        <translation>深度测试未通过(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Clip</source>
        <translation>裁剪(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;NaN or infinity</source>
        <translation>NaN 或无穷大(&amp;N)</translation>
    </message>
    <message>
        <source>Spee&amp;d</source>
        <translation>速度(&amp;D)</translation>
    </message>
    <message>
        <source>Slower</source>
        <translation>更慢</translation>
    </message>
    <message>
        <source>Faster</source>
        <translation>更快</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>步骤</translation>
    </message>
    <message>
        <source>S&amp;tep</source>
        <translation>步骤(&amp;T)</translation>
    </message>
    <message>
        <source>Space play · ← → step · Shift row · Ctrl face · Ctrl+Shift stage</source>
        <translation>空格播放 · ← → 单步 · Shift 行 · Ctrl 面 · Ctrl+Shift 阶段</translation>
    </message>
    <message>
        <source>run until ▾</source>
        <translation>运行到 ▾</translation>
    </message>
    <message>
        <source>cull</source>
        <translation>剔除</translation>
    </message>
    <message>
        <source>clip</source>
        <translation>裁剪</translation>
    </message>
    <message>
        <source>inside</source>
        <translation>在内</translation>
    </message>
    <message>
        <source>outside</source>
        <translation>在外</translation>
    </message>
    <message>
        <source>tie</source>
        <translation>平局</translation>
    </message>
    <message>
        <source>depth fail</source>
        <translation>深度未通过</translation>
    </message>
    <message>
        <source>step %1 of %2</source>
        <translation>第 %1 步，共 %2 步</translation>
    </message>
    <message>
        <source>recording …</source>
        <translation>正在记录 …</translation>
    </message>
    <message>
        <source>truncated at %1 events: record less</source>
        <translation>在 %1 个事件处截断：请缩小记录范围</translation>
    </message>
    <message>
        <source>Press R or play to record every decision of this frame</source>
        <translation>按 R 键或播放，记录这一帧的每个决定</translation>
    </message>
    <message>
        <source>the cleared frame</source>
        <translation>清空的帧</translation>
    </message>
    <message>
        <source>whole frame</source>
        <translation>整帧</translation>
    </message>
    <message>
        <source>one face</source>
        <translation>一个面</translation>
    </message>
    <message>
        <source>rectangle</source>
        <translation>矩形</translation>
    </message>
    <message>
        <source>speed %1 ▾</source>
        <translation>速度 %1 ▾</translation>
    </message>
</context>
<context>
    <name>rasterlens::ViewportWidget</name>
    <message>
        <source>former picture</source>
        <translation>先前的图像</translation>
    </message>
</context>
</TS>
