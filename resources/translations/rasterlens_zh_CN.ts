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
        <source>Column fill counts in whole rows and columns.</source>
        <translation>逐列填充只用整数的行和列。</translation>
    </message>
    <message>
        <source>Column fill evaluates no edge functions.</source>
        <translation>逐列填充不计算边函数。</translation>
    </message>
    <message>
        <source>Column fill takes the outline of every triangle with it.</source>
        <translation>逐列填充把每个三角形的轮廓也算在内。</translation>
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
        <source>The tiled algorithm steps through blocks of samples in its own way.</source>
        <translation>分块算法以自己的方式逐块处理样本。</translation>
    </message>
    <message>
        <source>The tiled algorithm shades visible samples only, each once.</source>
        <translation>分块算法只为可见样本着色，每个一次。</translation>
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
        <source>Only texture and Phong shading read texels.</source>
        <translation>只有纹理着色和 Phong 着色才读取纹素。</translation>
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
        <source>auto (%1)</source>
        <translation>自动 (%1)</translation>
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
        <source>Only MSAA shades a pixel elsewhere than at its samples.</source>
        <translation>只有 MSAA 会在采样点以外的位置给像素着色。</translation>
    </message>
    <message>
        <source>A pixel has one sample, and no mean is taken.</source>
        <translation>每个像素只有一个采样点，不求平均。</translation>
    </message>
    <message>
        <source>The diamonds alone decide which pixels a line has.</source>
        <translation>一条线有哪些像素，只由菱形决定。</translation>
    </message>
    <message>
        <source>Squares of pixels are asked for, not centres: what touches one touches it.</source>
        <translation>问的是像素的方格而不是中心：触及即算触及。</translation>
    </message>
    <message>
        <source>The corners of a pixel are asked one by one.</source>
        <translation>像素的角点逐个求值。</translation>
    </message>
    <message>
        <source>Only filled triangles ask whether a pixel is inside.</source>
        <translation>只有填充的三角形才问像素是否在内。</translation>
    </message>
    <message>
        <source>Only the wireframe draws the edges of faces.</source>
        <translation>只有线框模式才画面的边。</translation>
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
        <translation>开放曲面：叶片背对我们的地方会被背面剔除撕开一个洞。请关闭剔除。</translation>
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
    <message>
        <source>The square, hits counted</source>
        <translation>正方形，命中计数</translation>
    </message>
    <message>
        <source>The square cut by its diagonal; colours tell how many triangles cover a pixel. It must be one.</source>
        <translation>被对角线切开的正方形；颜色表示一个像素被几个三角形覆盖。应当恰好是一个。</translation>
    </message>
    <message>
        <source>A panel close before a wall</source>
        <translation>紧贴墙面的板</translation>
    </message>
    <message>
        <source>As in z-fighting, but with the near plane at 0.5: 32-bit depth can tell panel and wall apart, 16 bits cannot.</source>
        <translation>与“深度冲突”相同，但近平面在 0.5：32 位深度能分开板和墙，16 位不能。</translation>
    </message>
    <message>
        <source>Near, far, middle</source>
        <translation>近、远、中</translation>
    </message>
    <message>
        <source>Three rectangles, sent in this order: orange in front, blue at the back, green between them.</source>
        <translation>三个矩形按此顺序提交：橙色在前，蓝色在后，绿色在中间。</translation>
    </message>
    <message>
        <source>Two squares, two windings</source>
        <translation>两个正方形，两种环绕方向</translation>
    </message>
    <message>
        <source>The left square is counter-clockwise, the right one clockwise. A rule must treat both alike. Colours tell how many triangles cover a pixel.</source>
        <translation>左边的正方形逆时针，右边的顺时针。规则必须同等对待。颜色表示一个像素被几个三角形覆盖。</translation>
    </message>
    <message>
        <source>Tiles smaller than a pixel</source>
        <translation>比像素还小的瓷砖</translation>
    </message>
    <message>
        <source>From half a pixel on the left to several on the right. However small they are, together they cover every pixel once.</source>
        <translation>左边半个像素，到右边几个像素。无论多小，它们合起来恰好把每个像素覆盖一次。</translation>
    </message>
    <message>
        <source>Edges between samples</source>
        <translation>样本之间的边</translation>
    </message>
    <message>
        <source>2 x 2 samples a pixel. The orange triangle is nearer and sent first; the white square is cut by its diagonal, of which nothing may be seen.</source>
        <translation>每像素 2 × 2 个采样点。橙色三角形更近且先提交；白色正方形被对角线切开，而对角线不应被看见。</translation>
    </message>
    <message>
        <source>Triangles without area</source>
        <translation>没有面积的三角形</translation>
    </message>
    <message>
        <source>Three triangles are flattened to lines through pixel centres. They must not be seen.</source>
        <translation>三个三角形被压成穿过像素中心的线。它们不应被看见。</translation>
    </message>
    <message>
        <source>Two needles of 4,000 pixels</source>
        <translation>两根 4,000 像素的细针</translation>
    </message>
    <message>
        <source>They share a long edge. What is added up along it must not drift.</source>
        <translation>它们共享一条长边。沿边累加的值不能漂移。</translation>
    </message>
    <message>
        <source>A triangle of 60,000 pixels</source>
        <translation>60,000 像素的三角形</translation>
    </message>
    <message>
        <source>Not clipped: on the left half of the screen an edge value needs more than 32 bits.</source>
        <translation>未裁剪：在屏幕左半边，边函数值超过 32 位。</translation>
    </message>
    <message>
        <source>Over the right border</source>
        <translation>超出右边界</translation>
    </message>
    <message>
        <source>With a guard band the triangle is not clipped; the bounding box alone keeps it on the screen.</source>
        <translation>有保护带时三角形不被裁剪；只靠包围盒把它留在屏幕内。</translation>
    </message>
    <message>
        <source>Leaves cut out of squares</source>
        <translation>从方片中剪出的叶子</translation>
    </message>
    <message>
        <source>Six squares and a wall, sent from front to back. Around each leaf the texture is transparent: without the alpha test the corners of a square hide what lies behind, because they write depth although nothing is to be seen there.</source>
        <translation>六个方片和一面墙，由前到后送出。每片叶子周围的纹理是透明的：不做 alpha 测试时，方片的四角会挡住后面的东西，因为那里虽然什么也看不见，却写入了深度。</translation>
    </message>
    <message>
        <source>GAMES101: the same pixels, tilted</source>
        <translation>GAMES101：同样的像素，倾斜的三角形</translation>
    </message>
    <message>
        <source>The two triangles of GAMES101 with every corner moved along its ray to the eye: they cover the same pixels, but the w of a face are 3.5, 7, 14 and 10, 20, 5. Affine interpolation, a lost w and a corrected depth show here.</source>
        <translation>GAMES101 的两个三角形，每个顶点沿着通向眼睛的射线移动：覆盖的像素完全相同，但两个面的 w 是 3.5、7、14 和 10、20、5。仿射插值、丢失的 w、被校正的深度在这里都看得出来。</translation>
    </message>
    <message>
        <source>Flat edges</source>
        <translation>平缓的边</translation>
    </message>
    <message>
        <source>Three arrow heads, whose lower halves mirror the upper ones. The edges of the flattest fall by 2 rows on 28 columns: what is off by a part of a row is off by many columns.</source>
        <translation>三个箭头，下半部分是上半部分的镜像。最扁的那个，边在 28 列里只下降 2 行：差不到一行，就会差很多列。</translation>
    </message>
    <message>
        <source>A cut edge through pixel centres</source>
        <translation>穿过像素中心、又被裁剪的边</translation>
    </message>
    <message>
        <source>The common edge y = x + 8 runs through the centres of 40 pixels. It is cut at the left border for the orange triangle; the blue one has a corner there. The corner outside has code 1001: cut on the left it is still 1000, above.</source>
        <translation>公共边 y = x + 8 穿过 40 个像素的中心。橙色三角形的这条边在左边界被裁剪；蓝色三角形在那里正好有一个顶点。外面的顶点编码是 1001：在左边裁剪之后还是 1000，在上方。</translation>
    </message>
    <message>
        <source>A screen of 320 x 240</source>
        <translation>320 x 240 的屏幕</translation>
    </message>
    <message>
        <source>Points over the border</source>
        <translation>越过边界的点</translation>
    </message>
    <message>
        <source>A point in every pixel, and more of them beyond the left and the upper border. Colours tell how often a pixel is hit: once.</source>
        <translation>每个像素一个点，左边和上边之外还有更多。颜色表示像素被击中几次：一次。</translation>
    </message>
    <message>
        <source>A letter before two pillars</source>
        <translation>两根柱子前的字母</translation>
    </message>
    <message>
        <source>The red pillar stands on the left, the green one on the right, and the floor ends behind them: every wrong step of the camera shows.</source>
        <translation>红柱子在左，绿柱子在右，地面在它们后面结束：相机的每一步错误都看得见。</translation>
    </message>
    <message>
        <source>A road from far right to behind</source>
        <translation>从右边远处通到身后的路</translation>
    </message>
    <message>
        <source>The corners on the left lie behind the eye. Divided by their negative w they come out on the right, where all others are.</source>
        <translation>左边的角点在眼睛后面。除以它们的负 w，结果落在右边，和其他角点一样。</translation>
    </message>
    <message>
        <source>A ball pressed flat</source>
        <translation>压扁的球</translation>
    </message>
    <message>
        <source>A sphere stretched by 1, 0.3 and 1. Its normals are not stretched but pressed the other way round.</source>
        <translation>按 1、0.3、1 拉伸的球。它的法线不是跟着拉伸，而是反过来压。</translation>
    </message>
    <message>
        <source>A picture of 10 x 10 texels</source>
        <translation>10 x 10 纹素的图片</translation>
    </message>
    <message>
        <source>A letter in a frame that is one texel wide on every side, blended between the centres of texels.</source>
        <translation>带边框的字母，边框每边宽一个纹素，在纹素中心之间混合。</translation>
    </message>
    <message>
        <source>Texels left and right of 0</source>
        <translation>0 左右的纹素</translation>
    </message>
    <message>
        <source>u and v are 0 in the middle and run from -1.5 to 1.5. All texels are 8 pixels wide.</source>
        <translation>u 和 v 在中央为 0，从 -1.5 到 1.5。所有纹素宽 8 个像素。</translation>
    </message>
    <message>
        <source>Discs to the horizon</source>
        <translation>延伸到地平线的圆盘</translation>
    </message>
    <message>
        <source>A texture with mip levels that repeats every 2.5 units. Where it repeats, both sides have one colour.</source>
        <translation>带 mip 级别的纹理，每 2.5 个单位重复一次。重复处两侧是同一种颜色。</translation>
    </message>
    <message>
        <source>A glazed ball of few faces</source>
        <translation>面很少的上釉的球</translation>
    </message>
    <message>
        <source>48 cells with smooth normals. In the highlights light is brighter than a screen can show.</source>
        <translation>48 格，法线平滑。高光处的光比屏幕能显示的更亮。</translation>
    </message>
    <message>
        <source>All corners lie on the screen, yet twice the area is 67,944: 16 bits, of which one is for the sign, hold it no more.</source>
        <translation>角点都在屏幕上，面积的两倍却是 67,944：带符号的 16 位放不下。</translation>
    </message>
    <message>
        <source>Corners between the rows</source>
        <translation>角点在行之间</translation>
    </message>
    <message>
        <source>Three arrow heads, whose lower halves mirror the upper ones. Their tips lie at half rows, the other corners elsewhere between them.</source>
        <translation>三个箭头，下半边是上半边的镜像。箭尖在半行处，其余角点也在行之间。</translation>
    </message>
    <message>
        <source>MSAA: sheets with a part of a texture</source>
        <translation>MSAA：只用纹理一部分的薄片</translation>
    </message>
    <message>
        <source>4 samples a pixel, attributes at centroids. Round the sheets&apos; part of the texture all is magenta, which must not be seen.</source>
        <translation>每个像素 4 个采样点，属性取在质心。薄片所用的那部分纹理四周全是品红色，它不该出现。</translation>
    </message>
    <message>
        <source>MSAA: needles under fine stripes</source>
        <translation>MSAA：细条纹下的针形三角形</translation>
    </message>
    <message>
        <source>8 samples a pixel, attributes at centroids. The needles lie in one plane, and their stripes are finer than the pixels: all must be grey.</source>
        <translation>每个像素 8 个采样点，属性取在质心。这些针形三角形位于同一平面，条纹比像素还细：应当全是灰色。</translation>
    </message>
    <message>
        <source>MSAA: a disc of 20 triangles</source>
        <translation>MSAA：由 20 个三角形组成的圆盘</translation>
    </message>
    <message>
        <source>4 samples a pixel. The triangles share their edges, of which nothing may be seen.</source>
        <translation>每个像素 4 个采样点。三角形共用各条边，这些边不该看得见。</translation>
    </message>
    <message>
        <source>Paint on a road</source>
        <translation>路面上的漆</translation>
    </message>
    <message>
        <source>Two passes: the road, then paint in its plane. Depths of the two are as good as equal, and without the depth bias chance decides pixel by pixel which is nearer.</source>
        <translation>两遍：先画路面，再画同一平面上的漆。两者的深度几乎相等，没有深度偏移时，哪个更近逐像素全凭偶然。</translation>
    </message>
    <message>
        <source>Wireframe over a surface</source>
        <translation>曲面上的线框</translation>
    </message>
    <message>
        <source>Two passes: a surface, then the lines of its faces. A pixel of a line is up to half a pixel beside the line; how much depth that is depends on the slope of the face.</source>
        <translation>两遍：先画曲面，再画各面的边线。线上的像素最多偏离线半个像素；这相当于多少深度，取决于面的坡度。</translation>
    </message>
    <message>
        <source>A second pass at equal depth</source>
        <translation>深度相等的第二遍</translation>
    </message>
    <message>
        <source>Two passes: a board, then tiles at the same depth, drawn where depths are equal. Each has another w, so that z/w is off by a rounding, which 16 bits must round away.</source>
        <translation>两遍：先画一块板，再画同一深度的瓷砖，只画在深度相等处。每块瓷砖的 w 不同，z/w 会差一次舍入，16 位深度应当把它舍掉。</translation>
    </message>
    <message>
        <source>A beam up to the eye</source>
        <translation>伸到眼前的方梁</translation>
    </message>
    <message>
        <source>The near plane cuts the beam, and one looks into it. Where depths are clamped in place of clipping, what lies before the plane is drawn too, all of it at depth 0.</source>
        <translation>近平面切开方梁，可以看进去。若用钳制深度代替裁剪，近平面之前的部分也被画出，深度全是 0。</translation>
    </message>
    <message>
        <source>Three pairs of triangles</source>
        <translation>三对三角形</translation>
    </message>
    <message>
        <source>Of each pair the warm triangle is nearer and is sent first. Two threads without a lock draw the two at the same time.</source>
        <translation>每一对里暖色的三角形更近，先提交。两个没有加锁的线程同时画这两个。</translation>
    </message>
    <message>
        <source>Diagonals drawn both ways</source>
        <translation>两个方向各画一次的对角线</translation>
    </message>
    <message>
        <source>Both triangles of a rectangle draw its diagonal, one from each end. It passes half-way between two pixels: a choice that depends on the direction makes it two pixels thick there.</source>
        <translation>矩形的两个三角形都画对角线，各从一端开始。线从两个像素正中间穿过：若选择取决于方向，那里就有两个像素粗。</translation>
    </message>
</context>
<context>
    <name>Derive</name>
    <message>
        <source>The colour at the pixel (0 to 1, lit at the corners): the %1 of the three corners, each times its weight.</source>
        <translation>像素的颜色（0 到 1，已在顶点处算好光照）：三个顶点的 %1 各乘自己的权重，再相加。</translation>
    </message>
    <message>
        <source>The texture coordinates: the %1 of the three corners, each times its weight.</source>
        <translation>纹理坐标：三个顶点的 %1 各乘自己的权重，再相加。</translation>
    </message>
    <message>
        <source>The normal: the %1 of the three corners, each times its weight. The sum is shorter than 1 where the normals differ, and is made 1 long again before it is used.</source>
        <translation>法线：三个顶点的 %1 各乘自己的权重，再相加。各法线不同时，和的长度小于 1，使用前要重新归一化。</translation>
    </message>
    <message>
        <source>With the weights on the screen instead: what affine interpolation would show.</source>
        <translation>改用屏幕上的权重：仿射插值会显示的值。</translation>
    </message>
    <message>
        <source>Way 1. The three edge values have the same sum everywhere, so one division a triangle is enough: its reciprocal is kept.</source>
        <translation>方法一。三个边函数值之和处处相同，所以每个三角形只需一次除法：保存和的倒数。</translation>
    </message>
    <message>
        <source>Each corner is weighted by the edge opposite to it: the edge value is largest at the corner and 0 on the edge.</source>
        <translation>每个顶点的权重来自它的对边：边函数值在该顶点处最大，在这条边上为 0。</translation>
    </message>
    <message>
        <source>Way 2. The area of the triangle %1%2P, half a cross product.</source>
        <translation>方法二。三角形 %1%2P 的面积，即叉积的一半。</translation>
    </message>
    <message>
        <source>Each weight is the part that the triangle opposite the corner has of the whole area.</source>
        <translation>每个权重是顶点所对的小三角形占总面积的比例。</translation>
    </message>
    <message>
        <source>The vectors from P to the corners, each times the area opposite, cancel out: that is why these areas are the weights.</source>
        <translation>从 P 到各顶点的向量分别乘以所对的面积，相加为零（奔驰定理）：所以这些面积就是权重。</translation>
    </message>
    <message>
        <source>Way 3. The line equation of AB at P, over its value at C: 0 on AB and 1 at C.</source>
        <translation>方法三。直线 AB 的方程在 P 处的值除以它在 C 处的值：在 AB 上为 0，在 C 处为 1。</translation>
    </message>
    <message>
        <source>The line equation of AC at P, over its value at B.</source>
        <translation>直线 AC 的方程在 P 处的值除以它在 B 处的值。</translation>
    </message>
    <message>
        <source>What the other two leave: the weights add up to 1.</source>
        <translation>剩下的部分：权重之和为 1。</translation>
    </message>
    <message>
        <source>Way 4. P - C is to be alpha (A - C) + beta (B - C): two equations, one for x and one for y. The determinant of the two base vectors.</source>
        <translation>方法四。要求 P - C = α (A - C) + β (B - C)：x 和 y 各一个方程。这是两个基向量的行列式。</translation>
    </message>
    <message>
        <source>Cramer: P - C takes the place of the first column.</source>
        <translation>克拉默法则：用 P - C 替换第一列。</translation>
    </message>
    <message>
        <source>P - C takes the place of the second column.</source>
        <translation>用 P - C 替换第二列。</translation>
    </message>
    <message>
        <source>The cross product of the row of x and the row of y, each of A - C, B - C and C - P, has the three determinants as its parts: U = (Du, Dv, D).</source>
        <translation>把 A - C、B - C、C - P 的 x 排成一行、y 排成一行，两行的叉积正好以三个行列式为分量：U = (Du, Dv, D)。</translation>
    </message>
    <message>
        <source>Where U_z is nearly 0 the triangle has no area, and no weights.</source>
        <translation>U_z 接近 0 时三角形没有面积，也就没有权重。</translation>
    </message>
    <message>
        <source>Way 5. The line from %1 through P meets %2%3 in a point Q; Q lies s times as far from %1 as P.</source>
        <translation>方法五。从 %1 经过 P 的直线与 %2%3 交于点 Q；%1 到 Q 的距离是到 P 的 s 倍。</translation>
    </message>
    <message>
        <source>The point Q on the side.</source>
        <translation>边上的点 Q。</translation>
    </message>
    <message>
        <source>The part of the way from %1 to %2 at which Q lies.</source>
        <translation>Q 在从 %1 到 %2 的路程中所处的比例。</translation>
    </message>
    <message>
        <source>Ratios of lengths: PQ over %1Q for the corner, and the rest is shared between the ends of the side as Q divides it.</source>
        <translation>长度之比：该顶点的权重是 PQ 比 %1Q，其余部分按 Q 分割对边的比例分给两个端点。</translation>
    </message>
    <message>
        <source>The weights the program drew with put the corners together to P again.</source>
        <translation>用程序绘制时的权重把三个顶点合起来，又得到 P。</translation>
    </message>
    <message>
        <source>Their sum.</source>
        <translation>它们的和。</translation>
    </message>
    <message>
        <source>How far way %1 is from what the program drew with, in double precision.</source>
        <translation>方法 %1 的结果与程序绘制所用权重的差（双精度）。</translation>
    </message>
    <message>
        <source>The largest difference: rounding, and nothing else.</source>
        <translation>最大的差：只有舍入误差。</translation>
    </message>
    <message>
        <source>face %1 is not drawn</source>
        <translation>面 %1 没有被绘制</translation>
    </message>
    <message>
        <source>no step of the edge %1%2 is decided: it begins and ends in one pixel, or is not drawn by Bresenham&apos;s way</source>
        <translation>边 %1%2 上没有任何判断：它的起点和终点在同一个像素内，或者不是用 Bresenham 算法画的</translation>
    </message>
    <message>
        <source>face %1, edge %2%3</source>
        <translation>面 %1，边 %2%3</translation>
    </message>
    <message>
        <source>nothing is decided at pixel (%1, %2): the edge does not go on from there</source>
        <translation>在像素 (%1, %2) 处没有判断：这条边不从那里继续</translation>
    </message>
    <message>
        <source>How far the line goes along each axis; sx and sy say which way, 1 or -1.</source>
        <translation>直线在每个轴上走多远；sx、sy 表示方向，为 1 或 -1。</translation>
    </message>
    <message>
        <source>The line is steep: y takes a step every time, and x now and then. x and y change their parts.</source>
        <translation>直线陡：y 每次走一步，x 偶尔走一步。x 与 y 互换角色。</translation>
    </message>
    <message>
        <source>The line is flat: x takes a step every time, and y now and then.</source>
        <translation>直线平缓：x 每次走一步，y 偶尔走一步。</translation>
    </message>
    <message>
        <source>The line through both samples is x = m y + b.</source>
        <translation>过两个样本的直线是 x = m y + b。</translation>
    </message>
    <message>
        <source>The line through both samples is y = m x + b.</source>
        <translation>过两个样本的直线是 y = m x + b。</translation>
    </message>
    <message>
        <source>b from the first sample.</source>
        <translation>由第一个样本求 b。</translation>
    </message>
    <message>
        <source>Step %1: where the line itself is one step on.</source>
        <translation>第 %1 步：向前一步后，直线本身所在的位置。</translation>
    </message>
    <message>
        <source>From the sample straight on to the line.</source>
        <translation>从直行的样本到直线的距离。</translation>
    </message>
    <message>
        <source>From the line to the sample that also goes aside; both distances make 1.</source>
        <translation>从直线到同时侧移的样本的距离；两段距离之和为 1。</translation>
    </message>
    <message>
        <source>The sign of the difference decides. Times the length of the line, which is positive, no fraction is left in it.</source>
        <translation>由差的符号决定。乘以直线的长度（正数）后，其中就没有分数了。</translation>
    </message>
    <message>
        <source>What of it does not change from step to step.</source>
        <translation>其中每一步都不变的部分。</translation>
    </message>
    <message>
        <source>Multiplied out, with m = dy / dx: whole numbers only.</source>
        <translation>代入 m = dy / dx 并展开：只剩整数。</translation>
    </message>
    <message>
        <source>The line is nearer to the sample aside: that one is taken.</source>
        <translation>直线离侧移的样本更近：取它。</translation>
    </message>
    <message>
        <source>The line is not nearer to the sample aside: the next one straight on is taken.</source>
        <translation>直线并不更靠近侧移的样本：取直行的下一个。</translation>
    </message>
    <message>
        <source>The start. The line goes through the middle of its first sample: d_lower is 0 there and d_upper 1.</source>
        <translation>起点。直线穿过第一个样本的中心：那里 d_lower 为 0，d_upper 为 1。</translation>
    </message>
    <message>
        <source>One step straight on from there.</source>
        <translation>从那里直行一步。</translation>
    </message>
    <message>
        <source>The value the loop begins with.</source>
        <translation>循环开始时的值。</translation>
    </message>
    <message>
        <source>Sample (%1, %2): the step before went aside, which takes 2 lengths off.</source>
        <translation>样本 (%1, %2)：前一步侧移了，要减去两倍长度。</translation>
    </message>
    <message>
        <source>Sample (%1, %2): the step before went straight on.</source>
        <translation>样本 (%1, %2)：前一步是直行。</translation>
    </message>
    <message>
        <source>A tie at sample (%1, %2): both candidates are equally near. By the rule in words, p &lt;= 0, the line goes straight on.</source>
        <translation>样本 (%1, %2) 处相等：两个候选一样近。按文字规则 p &lt;= 0，直线直行。</translation>
    </message>
    <message>
        <source>It is right of the screen: the edge is cut there.</source>
        <translation>它在屏幕右侧之外：在右边界处裁切。</translation>
    </message>
    <message>
        <source>It is left of the screen: the edge is cut there.</source>
        <translation>它在屏幕左侧之外：在左边界处裁切。</translation>
    </message>
    <message>
        <source>It is above the screen: the edge is cut there.</source>
        <translation>它在屏幕上方之外：在上边界处裁切。</translation>
    </message>
    <message>
        <source>It is below the screen: the edge is cut there.</source>
        <translation>它在屏幕下方之外：在下边界处裁切。</translation>
    </message>
    <message>
        <source>Edge %1%2: both ends are beyond the same side. Nothing of it is seen: a null line.</source>
        <translation>边 %1%2：两端都在同一侧之外，完全看不见：空线段。</translation>
    </message>
    <message>
        <source>Edge %1%2: both codes are 0000. It lies inside, and is kept.</source>
        <translation>边 %1%2：两个区域编码都是 0000。它在内部，保留。</translation>
    </message>
    <message>
        <source>Edge %1%2: no side has both ends beyond it, so a part may be seen.</source>
        <translation>边 %1%2：没有哪一侧把两端都隔在外面，所以可能看得见一部分。</translation>
    </message>
    <message>
        <source>The weight of the new end: how far the border is from %1, over how far the other end is.</source>
        <translation>新端点的权重：边界到 %1 的距离，除以另一端到它的距离。</translation>
    </message>
    <message>
        <source>The new end %1 lies on the border.</source>
        <translation>新端点 %1 在边界上。</translation>
    </message>
    <message>
        <source>Its new code is %1. On the border it counts as inside; a program that takes it for outside has to move it in by a little (0.001), or the loop never ends.</source>
        <translation>它的新区域编码是 %1。在边界上算作内部；若程序把它当作外部，就必须向内移一点（0.001），否则循环永不结束。</translation>
    </message>
    <message>
        <source>The edge was cut on the screen, so attributes need the part of the way in space.</source>
        <translation>边是在屏幕上裁切的，所以属性需要空间中的路程比例。</translation>
    </message>
    <message>
        <source>w of the new end.</source>
        <translation>新端点的 w。</translation>
    </message>
    <message>
        <source>A worked example, not of this face: from U left of the screen to V above it. The codes have no bit in common, yet the edge passes the corner of the screen by.</source>
        <translation>一个算例，与此面无关：从屏幕左侧的 U 到屏幕上方的 V。两个区域编码没有相同的位，可这条边仍从屏幕角外经过。</translation>
    </message>
    <message>
        <source>What is left is drawn as a fan: each triangle takes one corner more.</source>
        <translation>剩下的部分画成三角扇：每多一个顶点就多一个三角形。</translation>
    </message>
    <message>
        <source>Plane %1: both ends are equally far from it, so the edge never meets it.</source>
        <translation>平面 %1：两端到它的距离相等，所以边永远不与它相交。</translation>
    </message>
    <message>
        <source>Plane %1: both ends are inside; the line meets it beyond them, with t outside of 0 to 1.</source>
        <translation>平面 %1：两端都在内侧；交点在线段之外，t 不在 0 到 1 之间。</translation>
    </message>
    <message>
        <source>Plane %1: both ends are outside; nothing of the edge is kept.</source>
        <translation>平面 %1：两端都在外侧；这条边什么也不保留。</translation>
    </message>
    <message>
        <source>Plane %1: the edge crosses it. t counts from the start of the edge to its end: the distance of the start over the difference of both.</source>
        <translation>平面 %1：边穿过它。t 从边的起点数到终点：起点的距离除以两端距离之差。</translation>
    </message>
    <message>
        <source>Plane %1: how far corner %2 is inside; outside is negative.</source>
        <translation>平面 %1：顶点 %2 在内侧多深；外侧为负。</translation>
    </message>
    <message>
        <source>Edge %1%2, inside to inside: its end %2 is kept.</source>
        <translation>边 %1%2，内到内：保留终点 %2。</translation>
    </message>
    <message>
        <source>Edge %1%2, outside to outside: nothing is kept.</source>
        <translation>边 %1%2，外到外：什么也不保留。</translation>
    </message>
    <message>
        <source>Edge %1%2, inside to outside: the cut is kept, its end %2 is not. t runs from the inside to the outside.</source>
        <translation>边 %1%2，内到外：保留交点，不保留终点 %2。t 从内侧数到外侧。</translation>
    </message>
    <message>
        <source>Edge %2%1, outside to inside: the cut is kept, and then its end %1. t runs from the inside to the outside.</source>
        <translation>边 %2%1，外到内：先保留交点，再保留终点 %1。t 从内侧数到外侧。</translation>
    </message>
    <message>
        <source>Counted from the start of the edge, as a text counts it. The program counts from the inside, so that both faces at an edge make the same corner.</source>
        <translation>按教材从边的起点数起。程序从内侧数起，这样共用一条边的两个面得到同一个顶点。</translation>
    </message>
    <message>
        <source>The new corner %1, in all four coordinates: clip space is linear.</source>
        <translation>新顶点 %1 的四个坐标：裁剪空间是线性的。</translation>
    </message>
    <message>
        <source>a corner of face %1 is no number</source>
        <translation>面 %1 有一个顶点不是数</translation>
    </message>
    <message>
        <source>T times end %1 of the edge. w has become the distance.</source>
        <translation>T 乘以边的端点 %1。w 变成了距离。</translation>
    </message>
    <message>
        <source>Divided by w.</source>
        <translation>除以 w。</translation>
    </message>
    <message>
        <source>So z&apos; is a hyperbola over the distance.</source>
        <translation>所以 z&apos; 是距离的反比例函数（双曲线）。</translation>
    </message>
    <message>
        <source>First proof. A point of the edge in space: a parts of end 1, 1 - a of end 2.</source>
        <translation>证明一。空间中边上的一点：端点 1 占 a，端点 2 占 1 - a。</translation>
    </message>
    <message>
        <source>The point itself through T and the divide.</source>
        <translation>该点本身经过 T 和除法。</translation>
    </message>
    <message>
        <source>x = z x&apos; / n put into the sum for x3: these stand before x1&apos; and x2&apos;.</source>
        <translation>把 x = z x&apos; / n 代入 x3 的和：这两个数是 x1&apos; 和 x2&apos; 的系数。</translation>
    </message>
    <message>
        <source>They add up to z3 / z3 = 1, so the second is 1 - b: straight lines stay straight.</source>
        <translation>它们之和是 z3 / z3 = 1，所以第二个是 1 - b：直线仍是直线。</translation>
    </message>
    <message>
        <source>The place on the screen, from those of the ends.</source>
        <translation>由两端的屏幕位置得到该点的屏幕位置。</translation>
    </message>
    <message>
        <source>One over the distance.</source>
        <translation>距离的倒数。</translation>
    </message>
    <message>
        <source>1 / z is linear on the screen: a / z3 = b / z1, and the other end alike.</source>
        <translation>1 / z 在屏幕上是线性的：a / z3 = b / z1，另一端也一样。</translation>
    </message>
    <message>
        <source>Put into z&apos; = n + f - n f / z.</source>
        <translation>代入 z&apos; = n + f - n f / z。</translation>
    </message>
    <message>
        <source>Sorted by b: z&apos; is linear on the screen, with the weights of x&apos; and y&apos;.</source>
        <translation>按 b 整理：z&apos; 在屏幕上是线性的，权重与 x&apos;、y&apos; 相同。</translation>
    </message>
    <message>
        <source>Second proof. Suppose P&apos; lies between A&apos; and B&apos; with b. The two ratios, in space and on the screen.</source>
        <translation>证明二。假设 P&apos; 以 b 位于 A&apos; 与 B&apos; 之间。空间中和屏幕上的两个比值。</translation>
    </message>
    <message>
        <source>x3 / y3 = x3&apos; / y3&apos; holds if they differ by the ratio of the distances.</source>
        <translation>只要两个比值相差距离之比，就有 x3 / y3 = x3&apos; / y3&apos;。</translation>
    </message>
    <message>
        <source>The distance by the ratio in space.</source>
        <translation>由空间中的比值求距离。</translation>
    </message>
    <message>
        <source>The distance by b: one over it is linear, and the end of the first proof follows again.</source>
        <translation>由 b 求距离：它的倒数是线性的，接下来与证明一的结尾相同。</translation>
    </message>
    <message>
        <source>A distance of free choice on the curve; half-way from near to far unless another is asked for.</source>
        <translation>曲线上任选的一个距离；没有指定时取近平面与远平面的正中间。</translation>
    </message>
    <message>
        <source>The part of the way from near to far at which it comes to lie: what lay in the middle goes towards far.</source>
        <translation>变换后它在近到远之间的比例：原来在中间的点移向远平面。</translation>
    </message>
    <message>
        <source>As far behind the eye: the other branch of the curve.</source>
        <translation>眼睛后方同样远处：曲线的另一支。</translation>
    </message>
    <message>
        <source>What lies behind the eye comes out beyond far; so it is cut away before the divide.</source>
        <translation>眼睛后面的点会落到远平面之外；所以要在除法之前裁掉。</translation>
    </message>
    <message>
        <source>c is z / w of the program&apos;s own clip space at the ends. It is linear on the screen: b is the right weight.</source>
        <translation>c 是程序自己的裁剪空间中两端的 z / w。它在屏幕上是线性的：b 是正确的权重。</translation>
    </message>
    <message>
        <source>z / w &quot;corrected&quot; with the weight in space, as attributes are: wrong.</source>
        <translation>像属性那样用空间中的权重去“校正” z / w：错误。</translation>
    </message>
    <message>
        <source>Its error.</source>
        <translation>它的误差。</translation>
    </message>
    <message>
        <source>The distance itself with the weight on the screen: wrong.</source>
        <translation>距离本身却用屏幕上的权重：错误。</translation>
    </message>
    <message>
        <source>a scene in clip space has no distances of near and far</source>
        <translation>裁剪空间的场景没有近平面和远平面的距离</translation>
    </message>
    <message>
        <source>holds</source>
        <translation>成立</translation>
    </message>
    <message>
        <source>does not hold</source>
        <translation>不成立</translation>
    </message>
    <message>
        <source>The edge as a vector, from %1 to %2; y runs down.</source>
        <translation>边作为向量，从 %1 到 %2；y 轴向下。</translation>
    </message>
    <message>
        <source>From %1 to the sample P.</source>
        <translation>从 %1 到样本 P。</translation>
    </message>
    <message>
        <source>The cross product of the two vectors points along z, and has this length: twice the area of the triangle %1P, with a sign. What z the vectors themselves have does not matter to it.</source>
        <translation>两个向量的叉积沿 z 方向，长度是这个数：三角形 %1P 面积的两倍，带符号。向量自己的 z 是多少与它无关。</translation>
    </message>
    <message>
        <source>With y down the product is negative inside a triangle that runs counter-clockwise. The program turns the sign round, so that inside is positive; a text that keeps it tests F &lt;= 0.</source>
        <translation>y 轴向下时，逆时针三角形内部的叉积为负。程序把符号反过来，使内部为正；保留原符号的教材则判断 F &lt;= 0。</translation>
    </message>
    <message>
        <source>The coordinates put in.</source>
        <translation>代入坐标。</translation>
    </message>
    <message>
        <source>What stands before x, what stands before y, and what stands alone, once the products are multiplied out. P does not occur in them: they are computed once a triangle.</source>
        <translation>乘积展开后 x 的系数、y 的系数和常数项。其中没有 P：每个三角形只算一次。</translation>
    </message>
    <message>
        <source>The line equation: 0 on the edge, a plane over the picture.</source>
        <translation>直线方程：在边上为 0，在整幅图上是一个平面。</translation>
    </message>
    <message>
        <source>One sample to the right x grows by 1: one addition instead of two products.</source>
        <translation>向右一个样本，x 增加 1：用一次加法代替两次乘法。</translation>
    </message>
    <message>
        <source>One row down y grows by 1: the start of the next row is one addition away, too.</source>
        <translation>向下一行，y 增加 1：下一行的起始值也只差一次加法。</translation>
    </message>
    <message>
        <source>%1 is a left edge. t is the smallest value that counts as inside.</source>
        <translation>%1 是左边。t 是算作内部的最小值。</translation>
    </message>
    <message>
        <source>%1 is a top edge. t is the smallest value that counts as inside.</source>
        <translation>%1 是上边。t 是算作内部的最小值。</translation>
    </message>
    <message>
        <source>%1 is a right or bottom edge. t is the smallest value that counts as inside.</source>
        <translation>%1 是右边或下边。t 是算作内部的最小值。</translation>
    </message>
    <message>
        <source>The same formula for the edge %1.</source>
        <translation>对边 %1 用同一个公式。</translation>
    </message>
    <message>
        <source>On which side of %1 the sample lies.</source>
        <translation>样本在 %1 的哪一侧。</translation>
    </message>
    <message>
        <source>Wherever the sample lies, the three add up to twice the area of the triangle.</source>
        <translation>无论样本在哪里，三者之和都是三角形面积的两倍。</translation>
    </message>
    <message>
        <source>Which way the face looks is told by two of its edges, in the order of its corners. The first one.</source>
        <translation>面的朝向由按顶点顺序的两条边决定。第一条。</translation>
    </message>
    <message>
        <source>The second one.</source>
        <translation>第二条。</translation>
    </message>
    <message>
        <source>Twice the area with a sign: the z of AB x BC, turned round because y runs down.</source>
        <translation>带符号的两倍面积：AB x BC 的 z，因为 y 轴向下而反号。</translation>
    </message>
    <message>
        <source>A front face, if it holds. s is 1 where counter-clockwise is front, and -1 where clockwise is.</source>
        <translation>若成立就是正面。以逆时针为正面时 s 为 1，以顺时针为正面时 s 为 -1。</translation>
    </message>
    <message>
        <source>it lies outside the view volume</source>
        <translation>它在视景体之外</translation>
    </message>
    <message>
        <source>it is a back face, and those are culled</source>
        <translation>它是背面，而背面被剔除</translation>
    </message>
    <message>
        <source>it is a front face, and those are culled</source>
        <translation>它是正面，而正面被剔除</translation>
    </message>
    <message>
        <source>it has no area on the screen</source>
        <translation>它在屏幕上没有面积</translation>
    </message>
    <message>
        <source>a corner is no number</source>
        <translation>有一个顶点不是数</translation>
    </message>
    <message>
        <source>it holds no sample&apos;s centre</source>
        <translation>它不包含任何样本的中心</translation>
    </message>
    <message>
        <source>face %1 is not drawn: %2</source>
        <translation>面 %1 没有被绘制：%2</translation>
    </message>
    <message>
        <source>pixel (%1, %2) is not inside face %3</source>
        <translation>像素 (%1, %2) 不在面 %3 内</translation>
    </message>
    <message>
        <source>nothing of face %1 is shaded at pixel (%2, %3)</source>
        <translation>面 %1 在像素 (%2, %3) 处没有着色</translation>
    </message>
    <message>
        <source>corner %1 of face %2 is not in front of the eye: w is %3</source>
        <translation>面 %2 的顶点 %1 不在眼睛前方：w 为 %3</translation>
    </message>
    <message>
        <source>face %1</source>
        <translation>面 %1</translation>
    </message>
    <message>
        <source>face %1, pixel (%2, %3)</source>
        <translation>面 %1，像素 (%2, %3)</translation>
    </message>
    <message>
        <source>From A to %1, in the space of the mesh.</source>
        <translation>从 A 到 %1，在网格的空间中。</translation>
    </message>
    <message>
        <source>AB x AC stands at right angles to the face.</source>
        <translation>AB x AC 与面垂直。</translation>
    </message>
    <message>
        <source>Its length is twice the area.</source>
        <translation>它的长度是面积的两倍。</translation>
    </message>
    <message>
        <source>The normal, of length 1.</source>
        <translation>长度为 1 的法线。</translation>
    </message>
    <message>
        <source>l points to the light and has length 1, so n . l is the cosine of the angle between the two.</source>
        <translation>l 指向光源，长度为 1，所以 n . l 是两者夹角的余弦。</translation>
    </message>
    <message>
        <source>Whether the light falls on the front. A program that draws faces only where it holds takes the light for the eye.</source>
        <translation>光是否照在正面。只在成立时才画面的程序，是把光源当成了眼睛。</translation>
    </message>
    <message>
        <source>Some light is everywhere; the rest grows with the cosine, and never takes light away.</source>
        <translation>处处都有一些环境光；其余随余弦增加，绝不会减少光。</translation>
    </message>
    <message>
        <source>The colour of the face: that of its first corner times the brightness, as whole numbers up to 255.</source>
        <translation>面的颜色：第一个顶点的颜色乘以亮度，化为 0 到 255 的整数。</translation>
    </message>
    <message>
        <source>this scene has no light: its colours are shown as they are</source>
        <translation>这个场景没有光照：颜色按原样显示</translation>
    </message>
    <message>
        <source>face %1 has no area, and so no normal</source>
        <translation>面 %1 没有面积，因此没有法线</translation>
    </message>
    <message>
        <source>Face %1 is number %2 in the order: the mean distance of its corners (w of clip space) is its sort key.</source>
        <translation>面 %1 在顺序中是第 %2 个：排序键是各顶点距离（裁剪空间的 w）的平均值。</translation>
    </message>
    <message>
        <source>Face %1 is number %2 in the order: the mean depth of its corners (z / w) is its sort key.</source>
        <translation>面 %1 在顺序中是第 %2 个：排序键是各顶点深度（z / w）的平均值。</translation>
    </message>
    <message>
        <source>face %1 among %2</source>
        <translation>面 %1，共 %2 个面</translation>
    </message>
    <message>
        <source>Face %1 is painted before face %2, which covers it wherever both lie. Of equal keys the one that comes first in the mesh stays first.</source>
        <translation>面 %1 先画，面 %2 后画，重叠处由后者盖住。键相等时，网格中靠前的仍在前。</translation>
    </message>
    <message>
        <source>From the side: the eye at 0, the screen at distance 1, the ends of the edge at height X and distance Z (the w of clip space). A ray to the eye meets the screen at X / Z.</source>
        <translation>从侧面看：眼睛在 0，屏幕在距离 1 处，边的两端高度为 X、距离为 Z（裁剪空间的 w）。射向眼睛的光线在 X / Z 处与屏幕相交。</translation>
    </message>
    <message>
        <source>The point at the part m of the way on the screen.</source>
        <translation>屏幕上路程比例为 m 的点。</translation>
    </message>
    <message>
        <source>Parallels to the screen through the ends, up to the ray of P: what is seen as P&apos;%1&apos; and P&apos;%2&apos; is Z1 and Z2 times as long there.</source>
        <translation>过两端作屏幕的平行线，直到 P 的光线：屏幕上的 P&apos;%1&apos;、P&apos;%2&apos; 在那里分别长 Z1 倍和 Z2 倍。</translation>
    </message>
    <message>
        <source>The two triangles along the ray are similar, so n / (1 - n) = %1G / %2K: P divides the edge in space in this ratio. The size of the screen cancels out.</source>
        <translation>光线两旁的两个三角形相似，所以 n / (1 - n) = %1G / %2K：P 在空间中按这个比分割边。屏幕的大小被约去。</translation>
    </message>
    <message>
        <source>The same from the lengths.</source>
        <translation>由两段长度得到同一个比。</translation>
    </message>
    <message>
        <source>Solved for n: the part of the way in space.</source>
        <translation>解出 n：空间中的路程比例。</translation>
    </message>
    <message>
        <source>Put in again.</source>
        <translation>代回去。</translation>
    </message>
    <message>
        <source>With Z1 and Z2 exchanged, a mistake often seen, the near end weighs too little.</source>
        <translation>把 Z1 和 Z2 弄反（常见错误），近端的权重就太小。</translation>
    </message>
    <message>
        <source>The distance of P: linear in n.</source>
        <translation>P 的距离：对 n 是线性的。</translation>
    </message>
    <message>
        <source>With n put in.</source>
        <translation>代入 n。</translation>
    </message>
    <message>
        <source>Divided by Z1 Z2: 1 / Z is linear on the screen.</source>
        <translation>除以 Z1 Z2：1 / Z 在屏幕上是线性的。</translation>
    </message>
    <message>
        <source>The point of the edge at n is seen at P&apos; indeed.</source>
        <translation>边上 n 处的点确实在 P&apos; 处被看到。</translation>
    </message>
    <message>
        <source>n at this m where Z1 / Z2 is %1; it is m where both are equal.</source>
        <translation>Z1 / Z2 为 %1 时，这个 m 对应的 n；两者相等时 n 就是 m。</translation>
    </message>
    <message>
        <source>The same over a face, at the pixel: 1 / w is linear on the screen, so the weights on the screen give it, and it gives w.</source>
        <translation>在面上、在像素处也一样：1 / w 在屏幕上是线性的，所以由屏幕上的权重得到它，再得到 w。</translation>
    </message>
    <message>
        <source>The weights in space, which attributes are weighted with.</source>
        <translation>空间中的权重，属性用它们加权。</translation>
    </message>
    <message>
        <source>They add up to 1, because w was chosen so.</source>
        <translation>它们之和为 1，因为 w 就是这样取的。</translation>
    </message>
    <message>
        <source>From the matrix: it is linear, so w P&apos; = alpha wA A&apos; + beta wB B&apos; + gamma wC C&apos; with the weights in space; the last row is this sum.</source>
        <translation>由矩阵：它是线性的，所以用空间中的权重有 w P&apos; = α wA A&apos; + β wB B&apos; + γ wC C&apos;；最后一行就是这个和。</translation>
    </message>
    <message>
        <source>Divided by w: the weights of A&apos;, B&apos; and C&apos; on the screen.</source>
        <translation>除以 w：A&apos;、B&apos;、C&apos; 在屏幕上的权重。</translation>
    </message>
    <message>
        <source>Bresenham&apos;s decision</source>
        <translation>Bresenham 的判断</translation>
    </message>
    <message>
        <source>Edge function</source>
        <translation>边函数</translation>
    </message>
    <message>
        <source>Barycentric weights, five ways</source>
        <translation>重心坐标的五种求法</translation>
    </message>
    <message>
        <source>Perspective-correct weights</source>
        <translation>透视校正的权重</translation>
    </message>
    <message>
        <source>The curve of depth</source>
        <translation>深度曲线</translation>
    </message>
    <message>
        <source>Cut of an edge by the planes</source>
        <translation>平面裁切一条边</translation>
    </message>
    <message>
        <source>Cohen-Sutherland, edge by edge</source>
        <translation>Cohen-Sutherland：逐边</translation>
    </message>
    <message>
        <source>Along the edges, then along the span</source>
        <translation>先沿边，再沿扫描段</translation>
    </message>
    <message>
        <source>Flat light</source>
        <translation>平面光照</translation>
    </message>
    <message>
        <source>The painter&apos;s order</source>
        <translation>画家的顺序</translation>
    </message>
    <message>
        <source>An attribute as the sum of three</source>
        <translation>属性是三项之和</translation>
    </message>
    <message>
        <source>edge walking does not fill the pixel (%1, %2)</source>
        <translation>边步进没有填充像素 (%1, %2)</translation>
    </message>
    <message>
        <source>The long edge runs from the first corner to the third: t from y alone.</source>
        <translation>长边从第一个顶点到第三个：t 只由 y 决定。</translation>
    </message>
    <message>
        <source>The row lies in the upper half: the short edge runs from the first corner to the second.</source>
        <translation>该行在上半部分：短边从第一个顶点到第二个。</translation>
    </message>
    <message>
        <source>The row lies in the lower half: the short edge runs from the second corner to the third.</source>
        <translation>该行在下半部分：短边从第二个顶点到第三个。</translation>
    </message>
    <message>
        <source>The corners are sorted by y and numbered 1, 2, 3 from the top. The second is not above...</source>
        <translation>顶点按 y 排序，从上到下编号 1、2、3。第二个不在第一个之上……</translation>
    </message>
    <message>
        <source>...and not below its neighbours in this order.</source>
        <translation>……也不在第三个之下。</translation>
    </message>
    <message>
        <source>The centre line of the row, and the half it lies in: the second corner is where the triangle is divided.</source>
        <translation>该行的中心线，以及它所在的半部分：三角形在第二个顶点处分成两半。</translation>
    </message>
    <message>
        <source>Where the edge crosses the row: lerp(a, b, t) = a + t (b - a).</source>
        <translation>边与该行的交点：lerp(a, b, t) = a + t (b - a)。</translation>
    </message>
    <message>
        <source>The part of the way in space that belongs to this part of the way on the screen.</source>
        <translation>与屏幕上的这个路程比例相对应的空间中的路程比例。</translation>
    </message>
    <message>
        <source>Affine interpolation takes the part of the way on the screen for the part in space.</source>
        <translation>仿射插值把屏幕上的路程比例当作空间中的比例。</translation>
    </message>
    <message>
        <source>w there: it is an attribute like the others.</source>
        <translation>那里的 w：它和其他属性一样插值。</translation>
    </message>
    <message>
        <source>Along the span, from the long edge to the short one: the lerp number of the sample.</source>
        <translation>沿扫描段，从长边到短边：样本的插值系数。</translation>
    </message>
    <message>
        <source>What corner %1 contributes to the sample after both ways.</source>
        <translation>经过两次插值后，顶点 %1 对样本的贡献。</translation>
    </message>
    <message>
        <source>lines and points are drawn in the colours of the model: no light falls on them</source>
        <translation>线和点以模型自身的颜色绘制：光照不到它们</translation>
    </message>
    <message>
        <source>The least and the greatest x of the three corners.</source>
        <translation>三个顶点中最小与最大的 x。</translation>
    </message>
    <message>
        <source>The least and the greatest y. Whatever lies inside the triangle lies between these four numbers.</source>
        <translation>最小与最大的 y。三角形内部的一切都在这四个数之间。</translation>
    </message>
    <message>
        <source>Rounded outwards to whole numbers, as most programs do: floor for the lesser, ceil for the greater. The loop runs from left on, as long as x &lt; right.</source>
        <translation>像多数程序那样向外取整：较小的用 floor，较大的用 ceil。循环从 left 开始，直到 x &lt; right 不再成立。</translation>
    </message>
    <message>
        <source>The rows, in the same way. This box is never too small.</source>
        <translation>行也用同样的办法。这样的包围盒绝不会太小。</translation>
    </message>
    <message>
        <source>Only centres are tested, and they lie at x + 0.5: the first one that is not left of x_min, and the last one that is not right of x_max. This box leaves out columns that floor and ceil would test in vain.</source>
        <translation>只测试中心，中心位于 x + 0.5：第一个不在 x_min 左边的，和最后一个不在 x_max 右边的。这样的包围盒省去了 floor 与 ceil 会白白测试的列。</translation>
    </message>
    <message>
        <source>The first and the last row of centres.</source>
        <translation>中心的第一行与最后一行。</translation>
    </message>
    <message>
        <source>Held within the picture of W columns and H rows: what lies beyond cannot be drawn.</source>
        <translation>限制在 W 列 H 行的图像之内：超出的部分画不出来。</translation>
    </message>
    <message>
        <source>Not held within the picture: samples beyond it are tested, and would be written to other rows or other memory.</source>
        <translation>没有限制在图像之内：图像之外的样本也被测试，并会写到别的行或别的内存。</translation>
    </message>
    <message>
        <source>So many samples are tested for this triangle.</source>
        <translation>这个三角形要测试这么多样本。</translation>
    </message>
    <message>
        <source>The part of the picture: without a box every sample of it would be tested for every triangle.</source>
        <translation>占图像的比例：没有包围盒，每个三角形都要测试图像的每个样本。</translation>
    </message>
    <message>
        <source>Code that asks p &lt; 0 goes aside at a tie and plots (%1, %2) in place of (%3, %4), equally near. One sample later both ways are at one place again.</source>
        <translation>代码若判断 p &lt; 0，相等时就会侧移，画 (%1, %2) 而不是同样近的 (%3, %4)。再过一个样本，两种走法又到同一处。</translation>
    </message>
    <message>
        <source>Corner %1 lies behind the eye. -w &lt;= x and x &lt;= w cannot both hold where w is negative, so it is outside of every view volume. Divided by w first, -1 &lt;= x / w &lt;= 1, the conditions would turn round and let mirrored corners in.</source>
        <translation>顶点 %1 在眼睛后面。w 为负时 -w &lt;= x 与 x &lt;= w 不能同时成立，所以它在任何视景体之外。若先除以 w，写成 -1 &lt;= x / w &lt;= 1，不等号就会反向，让镜像的顶点混进来。</translation>
    </message>
    <message>
        <source>The matrix T that makes a box of the view volume, row by row; z is the distance in front of the eye. x is to become n x / z: n times x here, and the divide by z after it. With n = 0 all that x and y say would be lost.</source>
        <translation>把视景体变成长方体的矩阵 T，逐行写出；z 是眼睛前方的距离。x 要变成 n x / z：这里先乘 n，之后再除以 z。若 n = 0，x 与 y 的信息就全丢了。</translation>
    </message>
    <message>
        <source>y becomes n y / z.</source>
        <translation>y 变成 n y / z。</translation>
    </message>
    <message>
        <source>z has two numbers of its own, so that near and far can stay where they are.</source>
        <translation>z 有自己的两个数，使近平面与远平面都能留在原处。</translation>
    </message>
    <message>
        <source>w becomes the distance, which everything is divided by. A corner at the eye itself, z = 0, has no place: it must be cut away before the divide.</source>
        <translation>w 成为距离，一切都要除以它。正好在眼睛处的顶点 z = 0，没有位置：必须在除法之前裁掉。</translation>
    </message>
    <message>
        <source>What lies at near stays at near...</source>
        <translation>在近平面上的仍在近平面上……</translation>
    </message>
    <message>
        <source>...and what lies at far stays at far.</source>
        <translation>……在远平面上的仍在远平面上。</translation>
    </message>
    <message>
        <source>z&apos; over z, spaced by its logarithm: in front of the eye and behind it</source>
        <translation>z&apos; 随 z 的变化，横轴为对数刻度：眼睛前方与后方</translation>
    </message>
    <message>
        <source>Form 1, strict: the sample is inside if the least of the three edge values is positive. A centre on a shared edge is in neither triangle: holes.</source>
        <translation>形式 1，严格：三个边值中最小的为正，样本就在内部。公共边上的中心不属于任何一个三角形：出现洞。</translation>
    </message>
    <message>
        <source>Form 2, inclusive: 0 counts as inside. A centre on a shared edge is in both triangles: drawn twice.</source>
        <translation>形式 2，包含：0 也算内部。共享边上的中心属于两个三角形：画两次。</translation>
    </message>
    <message>
        <source>The cross products of a text with y down, or of corners in the other order: all three signs turn together.</source>
        <translation>y 向下时，或顶点顺序相反时课文里的叉积：三个符号一起反转。</translation>
    </message>
    <message>
        <source>Form 2 for these: inside is negative.</source>
        <translation>对它们用形式 2：负为内部。</translation>
    </message>
    <message>
        <source>Form 3: all &gt;= 0 or all &lt;= 0, whatever the order of the corners. That is so exactly if the least and the greatest have no different signs.</source>
        <translation>形式 3：全部 &gt;= 0 或全部 &lt;= 0，与顶点顺序无关。这恰好等价于最小值与最大值不异号。</translation>
    </message>
    <message>
        <source>Form 3, strict: all &gt; 0 or all &lt; 0.</source>
        <translation>形式 3，严格：全部 &gt; 0 或全部 &lt; 0。</translation>
    </message>
    <message>
        <source>Form 4: the weights of A, B and C. Outside one or two of them are negative, and their sum is still 1.</source>
        <translation>形式 4：A、B、C 的权重。在外部有一个或两个为负，而总和仍为 1。</translation>
    </message>
    <message>
        <source>Inside if no weight is negative: form 2 again, as the sum of the edge values has the sign of the triangle.</source>
        <translation>没有负的权重就在内部：这又是形式 2，因为边值之和与三角形同号。</translation>
    </message>
    <message>
        <source>Edge %1 is level. It is a top edge if it runs to the left.</source>
        <translation>边 %1 是水平的。若它向左走，就是上边。</translation>
    </message>
    <message>
        <source>Edge %1: with the corners counter-clockwise it is a left edge if it runs down the screen. Where the corners run clockwise the comparison turns round.</source>
        <translation>边 %1：顶点逆时针排列时，若它在屏幕上向下走，就是左边。顶点顺时针排列时，比较反过来。</translation>
    </message>
    <message>
        <source>What the program asks of %1. Under the top-left rule t is 0 for left and top edges, and the smallest value above 0 for the others: a bias of one step.</source>
        <translation>程序对 %1 的判断。按左上规则，左边和上边的 t 为 0，其余的 t 是大于 0 的最小值：偏移一步。</translation>
    </message>
    <message>
        <source>Counted over the whole triangle: samples that form 2 takes and form 1 does not. Their centres lie on an edge exactly.</source>
        <translation>对整个三角形计数：形式 2 收下而形式 1 不收的样本。它们的中心恰好在边上。</translation>
    </message>
    <message>
        <source>Those of them that the rule in use gives to this triangle; the others belong to its neighbours.</source>
        <translation>其中按当前规则归这个三角形的；其余的属于它的邻居。</translation>
    </message>
    <message>
        <source>From the side: eye O, screen at 1</source>
        <translation>侧视图：眼睛 O，屏幕在 1 处</translation>
    </message>
    <message>
        <source>The bounding box</source>
        <translation>包围盒</translation>
    </message>
    <message>
        <source>Inside, asked in four forms</source>
        <translation>内部判断的四种形式</translation>
    </message>
    <message>
        <source>The red that is stored: rounded once, to a whole number up to 255.</source>
        <translation>存下的红色：只舍入一次，得到不超过 255 的整数。</translation>
    </message>
    <message>
        <source>A colour type of bytes cuts off every product: the sum is up to 3 too dark.</source>
        <translation>用字节存颜色的类型会截断每个乘积：总和最多偏暗 3。</translation>
    </message>
    <message>
        <source>Suppose every face lets half of what is behind it through: a = 1/2. Face %1 is drawn over what is there, in the order in which faces are sent.</source>
        <translation>假设每个面都透过后面的一半：a = 1/2。按提交的顺序，面 %1 画在已有的颜色之上。</translation>
    </message>
    <message>
        <source>From far to near, as a painter works, face %1 comes here.</source>
        <translation>像画家那样由远到近，这里轮到面 %1。</translation>
    </message>
    <message>
        <source>Whether both orders make one colour (its red part). Where they do not, transparent faces have to be sorted.</source>
        <translation>两种顺序的颜色（红色部分）是否一致。不一致时，透明的面必须排序。</translation>
    </message>
    <message>
        <source>A depth test before shading asks this of face %1 where the depth of face %2 is stored. If it does not hold, the face is dropped, although half of it should shine through. A shader that changes depth has the same trouble: the test cannot know it yet.</source>
        <translation>着色前的深度测试在存有面 %2 的深度处对面 %1 这样判断。若不成立，这个面就被丢弃，尽管它的一半本该透出来。改写深度的着色器也有同样的麻烦：测试时还不知道新的深度。</translation>
    </message>
    <message>
        <source>no face is drawn at this pixel</source>
        <translation>这个像素没有画任何面</translation>
    </message>
    <message>
        <source>Some programs spread z / w over near to far again before they store it. That is linear, so comparisons come out as before; it is not the distance.</source>
        <translation>有些程序在存储之前又把 z / w 展开到近平面与远平面之间。这是线性的，所以比较的结果不变；但它并不是距离。</translation>
    </message>
    <message>
        <source>n(m) for Z1 / Z2; solid: this edge</source>
        <translation>不同 Z1 / Z2 的 n(m)；实线：这条边</translation>
    </message>
    <message>
        <source>Transparent faces, and who comes first</source>
        <translation>透明的面与先后顺序</translation>
    </message>
    <message>
        <source>A slip worth knowing: if (a.y &gt; b.y) swap(points); swap(w); has no braces, so w is exchanged all three times. The corners then have the w of C, B and A, whatever their heights.</source>
        <translation>值得知道的疏忽：if (a.y &gt; b.y) swap(points); swap(w); 没有花括号，所以三次都会交换 w。于是不论高低，各顶点得到的是 C、B、A 的 w。</translation>
    </message>
    <message>
        <source>A slip worth knowing: a program that exchanges the ends of the span, so that it runs from left to right, and forgets to exchange their w, takes this number in place of n.</source>
        <translation>值得知道的疏忽：程序为了从左到右而交换扫描段的两端，却忘了交换它们的 w，就会用这个数代替 n。</translation>
    </message>
    <message>
        <source>Over a face. How much the distances of its corners differ: if it is 0, the weights on the screen are those in space, and correction changes nothing.</source>
        <translation>对整个面。各顶点的距离相差多少：若为 0，屏幕上的权重就是空间中的权重，校正不改变任何东西。</translation>
    </message>
    <message>
        <source>A text that takes AC x AB has -n, and lets light travel along (0, 0, -1), away from the eye. Both signs cancel out: its n . l is the z of the normal.</source>
        <translation>有的课文取 AC x AB，得到 -n，并让光沿 (0, 0, -1) 远离眼睛传播。两个符号相互抵消：它的 n . l 就是法线的 z。</translation>
    </message>
    <message>
        <source>Its colour is n . l alone, from black to white; where n . l is not positive it draws nothing.</source>
        <translation>它的颜色只取 n . l，从黑到白；n . l 不为正时什么也不画。</translation>
    </message>
    <message>
        <source>A mistake is on: the new end is drawn this far off the border.</source>
        <translation>有错误打开：新端点画在离边界这么远的里面。</translation>
    </message>
    <message>
        <source>The headlight: l is the camera&apos;s backward axis, from the scene to the eye, and has length 1, so n . l is the cosine of the angle between the normal and the gaze.</source>
        <translation>头灯：l 是相机朝后的轴，从场景指向眼睛，长度为 1，所以 n . l 是法线与视线夹角的余弦。</translation>
    </message>
    <message>
        <source>An orthographic camera: the rays are parallel, and w is 1 at both ends of the edge. The divide by w changes nothing.</source>
        <translation>正交相机：光线互相平行，这条边两端的 w 都是 1。除以 w 什么也不改变。</translation>
    </message>
    <message>
        <source>Parallel rays divide the edge in space as its picture is divided: the part of the way in space is m itself.</source>
        <translation>平行光线在空间中分割这条边，与屏幕上的分割相同：空间中的比例就是 m 本身。</translation>
    </message>
    <message>
        <source>The formula of perspective says the same where both w are equal.</source>
        <translation>两个 w 相等时，透视公式给出同样的结果。</translation>
    </message>
    <message>
        <source>Over a face. All three w are 1: they do not differ.</source>
        <translation>在一个面上。三个 w 都是 1：没有差别。</translation>
    </message>
    <message>
        <source>At the pixel 1 / w is the sum of the weights on the screen, 1.</source>
        <translation>在这个像素处，1 / w 是屏幕上权重之和，即 1。</translation>
    </message>
    <message>
        <source>The weights in space are those on the screen: there is nothing to correct, and affine interpolation is right.</source>
        <translation>空间中的权重就是屏幕上的权重：无需校正，仿射插值是正确的。</translation>
    </message>
    <message>
        <source>From the side: the rays are parallel, the screen is the near plane</source>
        <translation>从侧面看：光线平行，屏幕是近平面</translation>
    </message>
    <message>
        <source>An orthographic matrix scales and moves z, the distance in front of the eye, so that near comes to c_n and far to c_f. Its last row is (0, 0, 0, 1): w is 1, and the divide changes nothing.</source>
        <translation>正交矩阵缩放并平移 z（眼睛前方的距离），使近平面到 c_n，远平面到 c_f。它的最后一行是 (0, 0, 0, 1)：w 为 1，除法什么也不改变。</translation>
    </message>
    <message>
        <source>Near comes to c_n...</source>
        <translation>近平面到 c_n……</translation>
    </message>
    <message>
        <source>...and far to c_f.</source>
        <translation>……远平面到 c_f。</translation>
    </message>
    <message>
        <source>End %1 of the edge: z&apos; is linear in the distance.</source>
        <translation>这条边的端点 %1：z&apos; 随距离线性变化。</translation>
    </message>
    <message>
        <source>A point of the edge: a parts of end 1, 1 - a of end 2. On the screen it divides the edge in the same way.</source>
        <translation>边上的一点：端点 1 占 a 份，端点 2 占 1 - a 份。它在屏幕上以同样的比例分割这条边。</translation>
    </message>
    <message>
        <source>Its z&apos;, by the same weights.</source>
        <translation>它的 z&apos;，用同样的权重。</translation>
    </message>
    <message>
        <source>The same from its distance: on the screen both are linear, and neither is to be corrected.</source>
        <translation>由它的距离得到同样的值：两者在屏幕上都是线性的，都无需校正。</translation>
    </message>
    <message>
        <source>A distance of free choice; half-way from near to far unless another is asked for.</source>
        <translation>可自由选择的距离；没有另外指定时，取近平面与远平面的正中。</translation>
    </message>
    <message>
        <source>The part of the way from near to far at which it comes to lie: half-way stays half-way, and equal steps of distance stay equal.</source>
        <translation>它落在从近到远的哪个比例处：正中仍在正中，相等的距离步长仍然相等。</translation>
    </message>
    <message>
        <source>z&apos; over z: a straight line</source>
        <translation>z&apos; 随 z 变化：一条直线</translation>
    </message>
    <message>
        <source>A mistake cuts both ends to whole columns, and fills both.</source>
        <translation>一个错误把两端截成整数列，并且两端都填充。</translation>
    </message>
    <message>
        <source>It fills the rows from the first whole height to the last.</source>
        <translation>它填充从第一个整数高度到最后一个整数高度的各行。</translation>
    </message>
    <message>
        <source>a mistake crosses the rows at whole heights, not at the centres that are interpolated to</source>
        <translation>一个错误在整数高度而不是在插值所用的中心处与各行相交</translation>
    </message>
    <message>
        <source>The outline put together again: the ends that are left (%1), and the corners of the screen that lie inside the face (%2). Edges alone lose those.</source>
        <translation>重新拼成轮廓：留下的端点（%1），以及落在面内的屏幕角点（%2）。只裁边会丢掉这些角点。</translation>
    </message>
    <message>
        <source>face %1 is a line, and covers no area</source>
        <translation>面 %1 是一条线，不覆盖面积</translation>
    </message>
    <message>
        <source>Z1 and Z2 exchanged, a mistake often seen: with both equal nothing shows it.</source>
        <translation>把 Z1 和 Z2 弄反（常见错误）：两者相等时看不出来。</translation>
    </message>
</context>
<context>
    <name>Diagnostic</name>
    <message>
        <source>there is no such built-in scene; expected one of: %1</source>
        <translation>没有这个内置场景；应为其中之一：%1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>%1 values; %2 expected</source>
        <translation>给了 %1 个值；要求：%2</translation>
    </message>
    <message>
        <source>%1 is not a whole number from %2 to %3</source>
        <translation>%1 不是 %2 到 %3 之间的整数</translation>
    </message>
    <message>
        <source>one</source>
        <translation>一个</translation>
    </message>
    <message>
        <source>%1 is not one of %2</source>
        <translation>%1 不在可用的值之中：%2</translation>
    </message>
    <message>
        <source>width and height</source>
        <translation>宽和高</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>red, green and blue</source>
        <translation>红、绿、蓝</translation>
    </message>
    <message>
        <source>%1 is not from 0 to 1</source>
        <translation>%1 不在 0 到 1 之间</translation>
    </message>
    <message>
        <source>x, y, width and height</source>
        <translation>x、y、宽和高</translation>
    </message>
    <message>
        <source>21 (x y z w r g b of three corners)</source>
        <translation>21 个（三个顶点的 x y z w r g b）</translation>
    </message>
    <message>
        <source>a key and a value are expected</source>
        <translation>应为一个键和一个值</translation>
    </message>
    <message>
        <source>the file ends without a size; &quot;size W H&quot; is expected</source>
        <translation>直到文件结束也没有尺寸；应有 &quot;size 宽 高&quot;</translation>
    </message>
    <message>
        <source>window: it is empty or not within the size %1 x %2</source>
        <translation>window：窗口为空，或不在尺寸 %1 x %2 之内</translation>
    </message>
    <message>
        <source>%1: warning: %2</source>
        <translation>%1：警告：%2</translation>
    </message>
    <message>
        <source>newmtl takes a name; ignored</source>
        <translation>newmtl 需要一个名称；已忽略</translation>
    </message>
    <message>
        <source>%1 stands before the first newmtl; ignored</source>
        <translation>%1 出现在第一个 newmtl 之前；已忽略</translation>
    </message>
    <message>
        <source>%1 is negative</source>
        <translation>%1 是负数</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>一个数</translation>
    </message>
    <message>
        <source>%1: %2; %3 expected, ignored</source>
        <translation>%1：%2；要求%3，已忽略</translation>
    </message>
    <message>
        <source>binary data (a zero byte); an MTL file is text</source>
        <translation>二进制数据（含零字节）；MTL 文件应为文本</translation>
    </message>
    <message>
        <source>usemtl: no material %1 in the MTL files; the default material is used</source>
        <translation>usemtl：MTL 文件中没有材质 %1；使用默认材质</translation>
    </message>
    <message>
        <source>mtllib %1: %2; the default material is used</source>
        <translation>mtllib %1：%2；使用默认材质</translation>
    </message>
    <message>
        <source>binary data (a zero byte); an OBJ file is text</source>
        <translation>二进制数据（含零字节）；OBJ 文件应为文本</translation>
    </message>
    <message>
        <source>there are no faces; at least one &quot;f&quot; statement is expected</source>
        <translation>没有面；至少应有一条 &quot;f&quot; 语句</translation>
    </message>
    <message>
        <source>%1 takes a name</source>
        <translation>%1 需要一个名称</translation>
    </message>
    <message>
        <source>%1 is not a statement of the OBJ format; ignored</source>
        <translation>%1 不是 OBJ 格式的语句；已忽略</translation>
    </message>
    <message>
        <source>%1: %2; a finite number is expected</source>
        <translation>%1：%2；应为有限数</translation>
    </message>
    <message>
        <source>%1: %2 numbers; %3 expected</source>
        <translation>%1：%2 个数；要求 %3 个</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 到 %2</translation>
    </message>
    <message>
        <source>f: %1 corners; at least 3 expected</source>
        <translation>f：%1 个顶点；至少 3 个</translation>
    </message>
    <message>
        <source>f: %1 is not a corner; v, v/vt, v//vn or v/vt/vn expected</source>
        <translation>f：%1 不是顶点；应为 v、v/vt、v//vn 或 v/vt/vn</translation>
    </message>
    <message>
        <source>indices count from 1</source>
        <translation>索引从 1 开始</translation>
    </message>
    <message>
        <source>%1 &quot;%2&quot; come before it</source>
        <translation>在它之前有 %1 个 &quot;%2&quot;</translation>
    </message>
    <message>
        <source>the file has %1 &quot;%2&quot;</source>
        <translation>文件中有 %1 个 &quot;%2&quot;</translation>
    </message>
    <message>
        <source>f: %1 index %2 is out of range; %3</source>
        <translation>f：%1 索引 %2 超出范围；%3</translation>
    </message>
    <message>
        <source>this is not a scene; an .obj or .case file, builtin:NAME or stress:NAME is expected</source>
        <translation>这不是场景；应为 .obj 或 .case 文件、builtin:名称 或 stress:名称</translation>
    </message>
    <message>
        <source>broken JSON: %1</source>
        <translation>JSON 有误：%1</translation>
    </message>
    <message>
        <source>a JSON object is expected: {&quot;rasterlens&quot;: 1, &quot;scene&quot;: NAME, &quot;settings&quot;: {..}}</source>
        <translation>应为 JSON 对象：{&quot;rasterlens&quot;: 1, &quot;scene&quot;: 名称, &quot;settings&quot;: {..}}</translation>
    </message>
    <message>
        <source>&quot;vertices&quot; takes an object</source>
        <translation>&quot;vertices&quot; 应为对象</translation>
    </message>
    <message>
        <source>&quot;vertices&quot; takes an index and a position: &quot;0&quot;: [x, y, z, w], not &quot;%1&quot;</source>
        <translation>&quot;vertices&quot; 应为索引和位置：&quot;0&quot;: [x, y, z, w]，而不是 &quot;%1&quot;</translation>
    </message>
    <message>
        <source>this is not a session of this program; &quot;rasterlens&quot;: %1 is expected</source>
        <translation>这不是本程序的会话；应有 &quot;rasterlens&quot;: %1</translation>
    </message>
    <message>
        <source>&quot;scene&quot; takes the name of a scene</source>
        <translation>&quot;scene&quot; 应为场景的名称</translation>
    </message>
    <message>
        <source>&quot;settings&quot; takes an object</source>
        <translation>&quot;settings&quot; 应为对象</translation>
    </message>
    <message>
        <source>&quot;vertices&quot; names vertex %1; the scene has %2, counted from 0</source>
        <translation>&quot;vertices&quot; 中有顶点 %1；场景共有 %2 个顶点，从 0 开始计数</translation>
    </message>
    <message>
        <source>the file cannot be written: %1</source>
        <translation>无法写入文件：%1</translation>
    </message>
    <message>
        <source>&quot;%1&quot; takes a number from %2 to %3</source>
        <translation>&quot;%1&quot; 应为 %2 到 %3 之间的数</translation>
    </message>
    <message>
        <source>&quot;%1&quot; takes an array of %2 numbers</source>
        <translation>&quot;%1&quot; 应为 %2 个数的数组</translation>
    </message>
    <message>
        <source>&quot;view&quot; has no key &quot;%1&quot; of this kind</source>
        <translation>&quot;view&quot; 中没有这种类型的键 &quot;%1&quot;</translation>
    </message>
    <message>
        <source>&quot;mistakes&quot; takes an array of mistake ids</source>
        <translation>&quot;mistakes&quot; 应为错误 id 的数组</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a value of %2, which takes: %3</source>
        <translation>&quot;%1&quot; 不是 %2 的值；可用的值：%3</translation>
    </message>
    <message>
        <source>&quot;size&quot; takes &quot;WIDTHxHEIGHT&quot; with 1 to %1 each</source>
        <translation>&quot;size&quot; 应为 &quot;宽x高&quot;，各为 1 到 %1</translation>
    </message>
    <message>
        <source>&quot;view&quot; takes an object</source>
        <translation>&quot;view&quot; 应为对象</translation>
    </message>
    <message>
        <source>there is no setting &quot;%1&quot;</source>
        <translation>没有 &quot;%1&quot; 这项设置</translation>
    </message>
    <message>
        <source>a size of 1 to %1 pixels each is expected</source>
        <translation>宽和高应各为 1 到 %1 像素</translation>
    </message>
    <message>
        <source>there is no such stress scene; expected: %1</source>
        <translation>没有这个压力测试场景；应为其中之一：%1</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>没有这个文件</translation>
    </message>
    <message>
        <source>this is a directory; a file is expected</source>
        <translation>这是目录；应为文件</translation>
    </message>
    <message>
        <source>this is a device or a pipe; a file is expected</source>
        <translation>这是设备或管道；应为文件</translation>
    </message>
    <message>
        <source>the file is larger than 2 GB</source>
        <translation>文件大于 2 GB</translation>
    </message>
    <message>
        <source>the file cannot be read: %1</source>
        <translation>无法读取文件：%1</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>文件为空</translation>
    </message>
    <message>
        <source>%1 is not finite</source>
        <translation>%1 不是有限数</translation>
    </message>
    <message>
        <source>%1 is beyond the range of float32</source>
        <translation>%1 超出 float32 的范围</translation>
    </message>
    <message>
        <source>a number is missing</source>
        <translation>缺少一个数</translation>
    </message>
    <message>
        <source>%1 is not a number</source>
        <translation>%1 不是数</translation>
    </message>
    <message>
        <source>the image is empty</source>
        <translation>图像为空</translation>
    </message>
    <message>
        <source>the image has %1 x %2 texels; at most %3 x %3 are read</source>
        <translation>图像有 %1 x %2 个纹素；最多读取 %3 x %3 个</translation>
    </message>
    <message>
        <source>the image has %1 x %2 texels and would take %3 MB; at most %4 MB are read</source>
        <translation>图像有 %1 x %2 个纹素，需要 %3 MB；最多读取 %4 MB</translation>
    </message>
    <message>
        <source>the image cannot be read: %1</source>
        <translation>无法读取图像：%1</translation>
    </message>
    <message>
        <source>the image ends early</source>
        <translation>图像数据不完整</translation>
    </message>
    <message>
        <source>a TGA image of type %1 with %2 bits is not supported</source>
        <translation>不支持 %2 位的 %1 型 TGA 图像</translation>
    </message>
    <message>
        <source>there is not enough memory for the image</source>
        <translation>内存不足，放不下这幅图像</translation>
    </message>
    <message>
        <source>there is not enough memory to open it</source>
        <translation>内存不足，无法打开</translation>
    </message>
    <message>
        <source>it was not opened: the system does not start so many threads</source>
        <translation>未能打开：系统无法启动这么多线程</translation>
    </message>
    <message>
        <source>the model is %1 across and %2 from 0, where even double keeps only steps of %3; move it nearer to 0 before it is exported</source>
        <translation>模型宽 %1，距 0 有 %2，那里连 double 的步长也有 %3；请在导出前把它移近 0</translation>
    </message>
    <message>
        <source>the model is %1 across and %2 from 0, where float32 keeps only steps of %3; positions are read in double and drawn about the origin (%4, %5, %6)</source>
        <translation>模型宽 %1，距 0 有 %2，那里 float32 的步长为 %3；坐标按 double 读入，并以 (%4, %5, %6) 为原点绘制</translation>
    </message>
    <message>
        <source>the file now has %1 vertices instead of %2: moved vertices are back where the file has them</source>
        <translation>文件现在有 %1 个顶点（原有 %2 个）：移动过的顶点已回到文件中的位置</translation>
    </message>
    <message>
        <source>%1; left out</source>
        <translation>%1；已略去</translation>
    </message>
    <message>
        <source>made by a newer version (%1); this one reads %2</source>
        <translation>由更新的版本（%1）生成；本版本读取 %2</translation>
    </message>
    <message>
        <source>the scene is neither at %1 nor, by its name, beside the session or in the folder above</source>
        <translation>场景既不在 %1，也没有按名字在会话旁边或上一级文件夹中找到</translation>
    </message>
    <message>
        <source>the scene is not at %1; %2 is used</source>
        <translation>场景不在 %1；改用 %2</translation>
    </message>
    <message>
        <source>there is no mistake &quot;%1&quot;</source>
        <translation>没有名为“%1”的错误</translation>
    </message>
    <message>
        <source>the text is %1; UTF-8 or ASCII is expected</source>
        <translation>文本是 %1 编码；应为 UTF-8 或 ASCII</translation>
    </message>
    <message>
        <source>the picture carries %1, which is not applied: its colours are taken as they are stored</source>
        <translation>图像带有%1，但不会应用：颜色按存储的值使用</translation>
    </message>
    <message>
        <source>a gamma of %1</source>
        <translation>伽马值 %1</translation>
    </message>
    <message>
        <source>the colour profile &quot;%1&quot;</source>
        <translation>颜色配置文件“%1”</translation>
    </message>
    <message>
        <source>no program reads from this pipe</source>
        <translation>没有程序从这个管道读取</translation>
    </message>
    <message>
        <source>it is a folder; the name of a file is expected</source>
        <translation>这是一个文件夹；应为文件名</translation>
    </message>
    <message>
        <source>the disk holds only a part of it</source>
        <translation>磁盘上只有它的一部分</translation>
    </message>
    <message>
        <source>it is in use as an input and would be overwritten; another name is expected</source>
        <translation>它正作为输入使用，会被覆盖；请换一个名字</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a format pictures are written in, which are: %2</source>
        <translation>“%1”不是可写出的图像格式，可用的有：%2</translation>
    </message>
    <message>
        <source>the picture is empty or too large</source>
        <translation>图像为空或太大</translation>
    </message>
    <message>
        <source>the picture cannot be made a %1: %2</source>
        <translation>图像无法存为 %1：%2</translation>
    </message>
    <message>
        <source>%1: note: %2</source>
        <translation>%1：提示：%2</translation>
    </message>
    <message>
        <source>%1: the file&apos;s name has other letters large: %2</source>
        <translation>%1：文件名的大小写不同：%2</translation>
    </message>
    <message>
        <source>%1: %2 is read from the folder of this file</source>
        <translation>%1：改从本文件所在的文件夹读取 %2</translation>
    </message>
    <message>
        <source>not drawn: %1</source>
        <translation>未绘制：%1</translation>
    </message>
    <message>
        <source>not statements of the MTL format; ignored: %1</source>
        <translation>不是 MTL 格式的语句，已忽略：%1</translation>
    </message>
    <message>
        <source>read, but no part of the lighting here: %1</source>
        <translation>已读取，但不参与这里的光照：%1</translation>
    </message>
    <message>
        <source>%1 takes a file name; ignored</source>
        <translation>%1 需要一个文件名；已忽略</translation>
    </message>
    <message>
        <source>%1: there is no option %2; ignored</source>
        <translation>%1：没有选项 %2；已忽略</translation>
    </message>
    <message>
        <source>%1: the value of %2 is missing or wrong; ignored</source>
        <translation>%1：%2 的值缺失或有误；已忽略</translation>
    </message>
    <message>
        <source>%1: %2 has no effect here</source>
        <translation>%1：%2 在此不起作用</translation>
    </message>
    <message>
        <source>and %1 more remarks like that on line %2</source>
        <translation>还有 %1 条与第 %2 行同类的说明</translation>
    </message>
    <message>
        <source>the text is UTF-16; UTF-8 is smaller and read everywhere</source>
        <translation>文本是 UTF-16；UTF-8 更小，到处都能读</translation>
    </message>
    <message>
        <source>another program shortened the file while it was read</source>
        <translation>读取时另一个程序截短了该文件</translation>
    </message>
    <message>
        <source>no mtllib names a file</source>
        <translation>没有 mtllib 语句指出文件</translation>
    </message>
    <message>
        <source>mtllib %1: %2</source>
        <translation>mtllib %1：%2</translation>
    </message>
    <message>
        <source>Blender writes Kd as linear light and vertex colours as they are shown; here both are shown as they stand, so Kd looks darker than in Blender</source>
        <translation>Blender 把 Kd 写成线性光，把顶点颜色写成显示值；这里两者都按原值显示，所以 Kd 看起来比在 Blender 中暗</translation>
    </message>
    <message>
        <source>%1; %2 beside it is read</source>
        <translation>%1；改读旁边的 %2</translation>
    </message>
    <message>
        <source>f: the outline of %1 corners crosses itself; its inside is a guess</source>
        <translation>f：%1 个角的轮廓自相交，内部只能猜测</translation>
    </message>
    <message>
        <source>none of the %1 &quot;f&quot; statements can be drawn</source>
        <translation>%1 条“f”语句都无法绘制</translation>
    </message>
    <message>
        <source>s: %1; a group&apos;s number or off expected</source>
        <translation>s：%1；应为组号或 off</translation>
    </message>
    <message>
        <source>x y z, x y z w or x y z r g b</source>
        <translation>x y z、x y z w 或 x y z r g b</translation>
    </message>
    <message>
        <source>v: a weight other than 1 is ignored</source>
        <translation>v：忽略不等于 1 的权重</translation>
    </message>
    <message>
        <source>f: only %1 of %2 corners are different; at least 3 expected</source>
        <translation>f：%2 个角中只有 %1 个不同；至少应有 3 个</translation>
    </message>
    <message>
        <source>f: %1 repeated corners are left out</source>
        <translation>f：略去 %1 个重复的角</translation>
    </message>
    <message>
        <source>f: v %1 is no position; the face is left out</source>
        <translation>f：v %1 不是位置；略去该面</translation>
    </message>
    <message>
        <source>#MRGB: %1 colours for %2 &quot;v&quot;; white where there is none</source>
        <translation>#MRGB：%2 个“v”只有 %1 种颜色；缺少处用白色</translation>
    </message>
    <message>
        <source>v: colours up to %1; all are divided by %2</source>
        <translation>v：颜色值最大为 %1；全部除以 %2</translation>
    </message>
    <message>
        <source>v: colours up to %1; shown as 1 where they are larger</source>
        <translation>v：颜色值最大为 %1；大于 1 的按 1 显示</translation>
    </message>
    <message>
        <source>%1 of %2 faces are seen edge-on or have no area</source>
        <translation>%2 个面中有 %1 个正好侧对视线或没有面积</translation>
    </message>
    <message>
        <source>orbit, for example --orbit 30,30</source>
        <translation>请转动视角，例如 --orbit 30,30</translation>
    </message>
    <message>
        <source>orbit by dragging the canvas</source>
        <translation>拖动画布以转动视角</translation>
    </message>
    <message>
        <source>%1 of %2 faces show their back and are culled</source>
        <translation>%2 个面中有 %1 个背面朝前，被剔除</translation>
    </message>
    <message>
        <source>--culling none draws them</source>
        <translation>--culling none 会绘制它们</translation>
    </message>
    <message>
        <source>C switches culling</source>
        <translation>按 C 切换剔除</translation>
    </message>
    <message>
        <source>%1 of %2 faces show their front and are culled</source>
        <translation>%2 个面中有 %1 个正面朝前，被剔除</translation>
    </message>
    <message>
        <source>%1 of %2 faces lie outside the view</source>
        <translation>%2 个面中有 %1 个在视野之外</translation>
    </message>
    <message>
        <source>--view fit shows all</source>
        <translation>--view fit 显示全部</translation>
    </message>
    <message>
        <source>Home shows the whole scene</source>
        <translation>按 Home 显示整个场景</translation>
    </message>
    <message>
        <source>%1 of %2 faces have a corner that is no finite number</source>
        <translation>%2 个面中有 %1 个含有非有限数的角</translation>
    </message>
    <message>
        <source>the scene has to be mended</source>
        <translation>需要修正场景</translation>
    </message>
    <message>
        <source>there are no faces</source>
        <translation>没有面</translation>
    </message>
    <message>
        <source>another scene has some</source>
        <translation>请换一个场景</translation>
    </message>
    <message>
        <source>%1 faces reach the screen, but each lies between the centres of pixels</source>
        <translation>%1 个面到达屏幕，但都落在像素中心之间</translation>
    </message>
    <message>
        <source>more --samples or a larger --size shows them</source>
        <translation>增大 --samples 或 --size 就能看到</translation>
    </message>
    <message>
        <source>more samples a pixel or a larger picture shows them</source>
        <translation>增加每像素采样数或放大图像就能看到</translation>
    </message>
    <message>
        <source>all %1 fragments failed the depth test</source>
        <translation>%1 个片元全部未通过深度测试</translation>
    </message>
    <message>
        <source>--depth-test less is the usual one</source>
        <translation>通常用 --depth-test less</translation>
    </message>
    <message>
        <source>T changes the depth test</source>
        <translation>按 T 更换深度测试</translation>
    </message>
    <message>
        <source>nothing is seen: %1; %2</source>
        <translation>什么也看不到：%1；%2</translation>
    </message>
    <message>
        <source>map_Kd %1: %2; drawn without texture</source>
        <translation>map_Kd %1：%2；绘制时不用纹理</translation>
    </message>
    <message>
        <source>map_d %1: %2; drawn without holes</source>
        <translation>map_d %1：%2；绘制时不开孔</translation>
    </message>
    <message>
        <source>%1: %2 behind the numbers is ignored</source>
        <translation>%1：数字之后的 %2 被忽略</translation>
    </message>
    <message>
        <source>usemtl: no mtllib says what the %1 materials are; all look like the default one</source>
        <translation>usemtl：没有 mtllib 说明这 %1 种材质；全部按默认材质绘制</translation>
    </message>
    <message>
        <source>newmtl: %1 comes a second time; the first one is used</source>
        <translation>newmtl：%1 第二次出现；采用第一次的定义</translation>
    </message>
    <message>
        <source>f: in %1 corners v counts from the start and vt or vn is -1, the last one; some programs mean none by it</source>
        <translation>f：%1 个角点的 v 从头计数，而 vt 或 vn 为 -1，即最后一个；有些程序用它表示“没有”</translation>
    </message>
    <message>
        <source>vn: %1 normals have length 0; those of the faces are used</source>
        <translation>vn：%1 个法线长度为 0；改用面的法线</translation>
    </message>
    <message>
        <source>f: %1 corners, cut without overlap; where corners come close to each other on the screen, snapping turns thin triangles over, and single samples are drawn twice</source>
        <translation>f：%1 个角点，剖分无重叠；角点在屏幕上彼此靠近时，对齐会使细长三角形翻转，个别采样点会被绘制两次</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is %2, not %3</source>
        <translation>“%1”是 %2，不是 %3</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is missing; it takes %2</source>
        <translation>缺少“%1”；它应为%2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; knows no &quot;%2&quot;; expected: %3</source>
        <translation>“%1”里没有“%2”；应为：%3</translation>
    </message>
    <message>
        <source>&quot;%1&quot; stands beside &quot;settings&quot;, not in it</source>
        <translation>“%1”写在“settings”旁边，不在它里面</translation>
    </message>
    <message>
        <source>&quot;%1&quot; stands twice in one object</source>
        <translation>“%1”在同一个对象里出现了两次</translation>
    </message>
    <message>
        <source>&quot;%1&quot; takes %2</source>
        <translation>“%1”应为%2</translation>
    </message>
    <message>
        <source>1 (first course) or 2 (second look)</source>
        <translation>1（第一遍）或 2（第二遍）</translation>
    </message>
    <message>
        <source>a list of objects</source>
        <translation>对象的列表</translation>
    </message>
    <message>
        <source>a list of texts</source>
        <translation>文字的列表</translation>
    </message>
    <message>
        <source>a number from 1/64 to 128</source>
        <translation>1/64 到 128 的数</translation>
    </message>
    <message>
        <source>a number, a text or a list of pixels [x, y]</source>
        <translation>数、文字，或像素 [x, y] 的列表</translation>
    </message>
    <message>
        <source>a pixel: [x, y], two whole numbers from 0 on</source>
        <translation>一个像素：[x, y]，两个从 0 开始的整数</translation>
    </message>
    <message>
        <source>a point of the picture: [x, y]</source>
        <translation>画面上的一个点：[x, y]</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>一段文字</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>一个对象</translation>
    </message>
    <message>
        <source>only questions of the kinds mistake and choice have &quot;choices&quot;</source>
        <translation>只有 mistake 和 choice 类的问题才有“choices”</translation>
    </message>
    <message>
        <source>pixel %1,%2 lies outside the picture</source>
        <translation>像素 %1,%2 在画面之外</translation>
    </message>
    <message>
        <source>slide %1: %2</source>
        <translation>第 %1 张幻灯片：%2</translation>
    </message>
    <message>
        <source>the caption does not have the same numbers in both languages</source>
        <translation>两种语言的说明里的数不一样</translation>
    </message>
    <message>
        <source>the caption names {%1}, which &quot;expect&quot; does not have</source>
        <translation>说明里有 {%1}，而“expect”里没有</translation>
    </message>
    <message>
        <source>the fact &quot;%1&quot; takes: %2</source>
        <translation>事实“%1”的写法：%2</translation>
    </message>
    <message>
        <source>the first slide asks a question and needs &quot;before&quot;, what is shown while it is open</source>
        <translation>第一张幻灯片提出问题，需要“before”，即回答之前显示的内容</translation>
    </message>
    <message>
        <source>the picture is not drawn</source>
        <translation>没有画出画面</translation>
    </message>
    <message>
        <source>the question has no answer: &quot;%1&quot;</source>
        <translation>这个问题没有答案：“%1”</translation>
    </message>
    <message>
        <source>the record has no step &quot;%1&quot;</source>
        <translation>记录里没有步骤“%1”</translation>
    </message>
    <message>
        <source>there is no &quot;%1&quot; here</source>
        <translation>这里没有“%1”</translation>
    </message>
    <message>
        <source>there is no fact &quot;%1&quot;; &quot;rasterlens-cli lesson --facts&quot; lists them</source>
        <translation>没有事实“%1”；“rasterlens-cli lesson --facts”会列出全部</translation>
    </message>
    <message>
        <source>there is no key &quot;%1&quot; here; expected: %2</source>
        <translation>这里没有键“%1”；应为：%2</translation>
    </message>
    <message>
        <source>there is no scene &quot;%1&quot;; builtin:NAME, stress:NAME, case:NAME or an .obj or .case file is expected</source>
        <translation>没有场景“%1”；应为 builtin:NAME、stress:NAME、case:NAME，或 .obj、.case 文件</translation>
    </message>
    <message>
        <source>there is no such lesson; expected a .json file or one of: %1</source>
        <translation>没有这一课；应为 .json 文件，或其中之一：%1</translation>
    </message>
    <message>
        <source>there is no key &quot;%1&quot;; rasterlens, scene, settings, vertices and colors are expected</source>
        <translation>没有键 &quot;%1&quot;；可用的是 rasterlens、scene、settings、vertices 和 colors</translation>
    </message>
    <message>
        <source>&quot;colors&quot; takes an object</source>
        <translation>&quot;colors&quot; 需要一个对象</translation>
    </message>
    <message>
        <source>&quot;colors&quot; takes an index and a colour: &quot;0&quot;: [r, g, b], each from 0 to 1, not &quot;%1&quot;</source>
        <translation>&quot;colors&quot; 需要序号和颜色：&quot;0&quot;: [r, g, b]，每个从 0 到 1，不能是 &quot;%1&quot;</translation>
    </message>
    <message>
        <source>&quot;colors&quot; names vertex %1; the scene has %2, counted from 0</source>
        <translation>&quot;colors&quot; 提到顶点 %1；场景有 %2 个，从 0 数起</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 和 %2</translation>
    </message>
    <message>
        <source>all w of these faces are equal: %1</source>
        <translation>这些面的所有 w 都相等：%1</translation>
    </message>
    <message>
        <source>the three w of each face are equal: %1</source>
        <translation>每个面的三个 w 都相等：%1</translation>
    </message>
    <message>
        <source>no face is cut, and none is rejected: all corners lie inside the view volume</source>
        <translation>没有面被裁剪，也没有面被丢弃：所有顶点都在视景体内</translation>
    </message>
    <message>
        <source>every face is a front face</source>
        <translation>每个面都是正面</translation>
    </message>
    <message>
        <source>every face is a back face</source>
        <translation>每个面都是背面</translation>
    </message>
    <message>
        <source>no lines are drawn</source>
        <translation>没有画线</translation>
    </message>
    <message>
        <source>there is one sample a pixel</source>
        <translation>每个像素只有一个采样点</translation>
    </message>
    <message>
        <source>the picture is as wide as it is high</source>
        <translation>画面的宽和高相等</translation>
    </message>
    <message>
        <source>nothing is culled</source>
        <translation>没有剔除任何面</translation>
    </message>
    <message>
        <source>no material has a mask</source>
        <translation>没有材质带蒙版</translation>
    </message>
    <message>
        <source>the near plane is at %1, but must lie before the eye, at more than 0: with n = 0, z&apos; = n + f - nf/z is f for every z, and x&apos; = nx/z is 0 for every x</source>
        <translation>近平面在 %1，但它必须在眼睛前面，大于 0：n = 0 时，z&apos; = n + f - nf/z 对所有的 z 都是 f，x&apos; = nx/z 对所有的 x 都是 0</translation>
    </message>
    <message>
        <source>the far plane is at %1, but must lie before the eye, at more than 0</source>
        <translation>远平面在 %1，但它必须在眼睛前面，大于 0</translation>
    </message>
    <message>
        <source>the far plane is at %2, but must lie beyond the near plane at %1: z&apos; = n + f - nf/z runs from n to f, which leaves no depth between</source>
        <translation>远平面在 %2，但它必须在近平面 %1 之外：z&apos; = n + f - nf/z 从 n 到 f，这样中间就没有深度了</translation>
    </message>
    <message>
        <source>an array of shape %1 is no picture; (H, W), (H, W, 3) or (H, W, 4) is expected, at most %2 pixels a side</source>
        <translation>形状为 %1 的数组不是图片；应为 (H, W)、(H, W, 3) 或 (H, W, 4)，每边至多 %2 像素</translation>
    </message>
    <message>
        <source>%1 is no colour; 0 to 255, or 0 to 1 in floating point, is expected</source>
        <translation>%1 不是颜色；应为 0 到 255，浮点数应为 0 到 1</translation>
    </message>
    <message>
        <source>%1 x %2 pixels are too many to compare; at most %3 million</source>
        <translation>%1 x %2 像素太多，无法比较；至多 %3 百万</translation>
    </message>
    <message>
        <source>an animation has at most %1 pictures</source>
        <translation>一个动画最多有 %1 张图</translation>
    </message>
    <message>
        <source>the animation becomes larger than %1 million bytes</source>
        <translation>动画超过了 %1 百万字节</translation>
    </message>
    <message>
        <source>the scene is given in clip space: no camera projects it</source>
        <translation>场景以裁剪空间给出：没有相机来投影它</translation>
    </message>
    <message>
        <source>this scene has no light: its colours are shown as they are</source>
        <translation>这个场景没有光照：颜色按原样显示</translation>
    </message>
    <message>
        <source>lines and points are drawn without light</source>
        <translation>线和点绘制时不受光照</translation>
    </message>
    <message>
        <source>this shading asks for no light</source>
        <translation>这种着色不使用光照</translation>
    </message>
    <message>
        <source>the depth of an orthographic camera is linear in the distance</source>
        <translation>正交相机的深度随距离线性变化</translation>
    </message>
    <message>
        <source>&quot;light&quot; takes &quot;head&quot; or an array of three numbers that are not all 0</source>
        <translation>&quot;light&quot; 的值是 &quot;head&quot;，或由三个不全为 0 的数组成的数组</translation>
    </message>
    <message>
        <source>no sample lies exactly on an edge</source>
        <translation>没有采样点恰好落在边上</translation>
    </message>
    <message>
        <source>no sample is covered by two faces</source>
        <translation>没有采样点被两个面覆盖</translation>
    </message>
    <message>
        <source>fixed point is exact: adding up gives what the formula gives</source>
        <translation>定点数是精确的：逐步相加与代入公式的结果相同</translation>
    </message>
    <message>
        <source>either way every fragment is drawn</source>
        <translation>两种取值下每个片元都会画出</translation>
    </message>
    <message>
        <source>no depth is exactly the one that it is compared with</source>
        <translation>没有深度与它所比较的深度恰好相等</translation>
    </message>
    <message>
        <source>no material has a texture</source>
        <translation>没有材质带纹理</translation>
    </message>
    <message>
        <source>this shading reads no texels</source>
        <translation>这种着色不读纹素</translation>
    </message>
    <message>
        <source>no mip levels are looked up</source>
        <translation>没有查 mip 级别</translation>
    </message>
    <message>
        <source>the nearest texel is taken, and none is blended</source>
        <translation>取最近的纹素，不作混合</translation>
    </message>
    <message>
        <source>light is not computed at every pixel: the shading is not phong</source>
        <translation>光不是逐像素计算的：着色不是 phong</translation>
    </message>
    <message>
        <source>no points are drawn</source>
        <translation>没有画点</translation>
    </message>
    <message>
        <source>%1 is not a directive; size, subpixel_bits, exact, cull, depth_test, depth_format, depth_bias, depth_range, depth_clamp, depth_clear, second_pass, clear, ssaa, samples, attribute_at, coverage_rule, zrange, window, tri, triuv, line, line_rule, line_ties, texture, texture_filter, note or expect expected</source>
        <translation>%1 不是指令；应为 size、subpixel_bits、exact、cull、depth_test、depth_format、depth_bias、depth_range、depth_clamp、depth_clear、second_pass、clear、ssaa、samples、attribute_at、coverage_rule、zrange、window、tri、triuv、line、line_rule、line_ties、texture、texture_filter、note 或 expect</translation>
    </message>
    <message>
        <source>&quot;checker&quot; and a size, or the name of an image, is expected</source>
        <translation>应为 &quot;checker&quot; 和边长，或图片的文件名</translation>
    </message>
    <message>
        <source>27 (x y z w r g b u v of three corners)</source>
        <translation>27（三个角的 x y z w r g b u v）</translation>
    </message>
    <message>
        <source>needs MSAA: samples msaa2 to msaa16</source>
        <translation>需要 MSAA：samples msaa2 到 msaa16</translation>
    </message>
    <message>
        <source>only texture-filter trilinear asks for derivatives</source>
        <translation>只有 texture-filter trilinear 才需要导数</translation>
    </message>
    <message>
        <source>attributes are taken at the pixels&apos; centres</source>
        <translation>属性取在像素中心</translation>
    </message>
    <message>
        <source>it stands once, behind the triangles and lines of the first pass</source>
        <translation>它只能出现一次，并且在第一遍的三角形和线之后</translation>
    </message>
    <message>
        <source>two numbers n,f from 0 to 1</source>
        <translation>0 到 1 之间的两个数 n,f</translation>
    </message>
    <message>
        <source>two or three numbers c,s[,m] of at most 1e9: units, slopes, and the clamp</source>
        <translation>绝对值不超过 1e9 的两个或三个数 c,s[,m]：单位数、坡度倍数和上限</translation>
    </message>
    <message>
        <source>&quot;%1&quot; takes an array of %2</source>
        <translation>“%1”应为数组，内容是%2</translation>
    </message>
    <message>
        <source>14 (x y z w r g b of both ends)</source>
        <translation>14 个（两个端点的 x y z w r g b）</translation>
    </message>
    <message>
        <source>it lies outside the model&apos;s folder and is read only if that is allowed (--allow-outside)</source>
        <translation>它位于模型所在文件夹之外，只有在允许时才读取（--allow-outside）</translation>
    </message>
    <message>
        <source>the scene %1 lies outside the session&apos;s folder and is opened only if that is allowed (--allow-outside)</source>
        <translation>场景 %1 位于会话所在文件夹之外，只有在允许时才打开（--allow-outside）</translation>
    </message>
    <message>
        <source>the scene %1 lies outside the lesson&apos;s folder and is opened only if that is allowed (--allow-outside)</source>
        <translation>场景 %1 位于课程所在文件夹之外，只有在允许时才打开（--allow-outside）</translation>
    </message>
    <message>
        <source>the scene is neither at %1 nor, by its name, beside the session; other folders are looked at only if that is allowed (--allow-outside)</source>
        <translation>场景不在 %1，按名称也不在会话旁边；只有在允许时才查找其他文件夹（--allow-outside）</translation>
    </message>
</context>
<context>
    <name>Experiment</name>
    <message>
        <source>wrong pixels: missing, extra or hit twice</source>
        <translation>错误像素：缺失、多余或重复命中</translation>
    </message>
    <message>
        <source>largest depth error, range 0 to 1</source>
        <translation>最大深度误差（范围 0 到 1）</translation>
    </message>
    <message>
        <source>colour error, root mean square, 8-bit steps</source>
        <translation>颜色误差（均方根，8 位级差）</translation>
    </message>
    <message>
        <source>ns per covered pixel</source>
        <translation>纳秒/被覆盖像素</translation>
    </message>
    <message>
        <source>million triangles a second</source>
        <translation>每秒百万三角形</translation>
    </message>
    <message>
        <source>other renderers</source>
        <translation>其他渲染器</translation>
    </message>
    <message>
        <source>Every variant is exact here:
all of these errors are 0.</source>
        <translation>这里每个变体都是精确的：
这种误差全部为 0。</translation>
    </message>
    <message>
        <source>this program was built without OpenGL: the headers of EGL (Debian: libegl-dev) were missing</source>
        <translation>本程序构建时不带 OpenGL：缺少 EGL 的头文件（Debian：libegl-dev）</translation>
    </message>
    <message>
        <source>there is no libEGL.so.1 on this machine (Debian: libegl1, libgl1-mesa-dri)</source>
        <translation>这台机器上没有 libEGL.so.1（Debian：libegl1、libgl1-mesa-dri）</translation>
    </message>
    <message>
        <source>no device of this machine draws by OpenGL 3.3 without a display (Debian: libgl1-mesa-dri)</source>
        <translation>这台机器上没有设备能在无显示器时用 OpenGL 3.3 绘图（Debian：libgl1-mesa-dri）</translation>
    </message>
</context>
<context>
    <name>HardCase</name>
    <message>
        <source>%1 pixels are covered</source>
        <translation>共覆盖 %1 个像素</translation>
    </message>
    <message>
        <source>every pixel is covered exactly once</source>
        <translation>每个像素恰好被覆盖一次</translation>
    </message>
    <message>
        <source>%1 holes</source>
        <translation>洞 %1 个</translation>
    </message>
    <message>
        <source>%1 pixels are covered by two faces or more</source>
        <translation>被两个或更多面覆盖的像素：%1 个</translation>
    </message>
    <message>
        <source>no pixel is covered by more than %1 faces</source>
        <translation>任何像素最多被 %1 个面覆盖</translation>
    </message>
    <message>
        <source>%3 faces cover pixel (%1, %2)</source>
        <translation>像素 (%1, %2) 被 %3 个面覆盖</translation>
    </message>
    <message>
        <source>face %1 is seen in %2 pixels</source>
        <translation>面 %1 出现在 %2 个像素中</translation>
    </message>
    <message>
        <source>face %3 is seen at (%1, %2)</source>
        <translation>在 (%1, %2) 看到面 %3</translation>
    </message>
    <message>
        <source>in %1 strips only the front is seen</source>
        <translation>有 %1 条带只看到前面的平面</translation>
    </message>
    <message>
        <source>the depth at (%1, %2) is %3</source>
        <translation>(%1, %2) 处的深度为 %3</translation>
    </message>
    <message>
        <source>the colour at (%1, %2) is %3 %4 %5</source>
        <translation>(%1, %2) 处的颜色为 %3 %4 %5</translation>
    </message>
    <message>
        <source>%1 faces are dropped for a position that is no number</source>
        <translation>有 %1 个面因坐标不是有限数而被丢弃</translation>
    </message>
    <message>
        <source>clipping makes %1 corners of a face</source>
        <translation>裁剪后一个面有 %1 个角</translation>
    </message>
    <message>
        <source>no face is seen at (%1, %2)</source>
        <translation>在 (%1, %2) 看不到任何面</translation>
    </message>
    <message>
        <source>first at (%1, %2)</source>
        <translation>首个在 (%1, %2)</translation>
    </message>
    <message>
        <source>%1 missing</source>
        <translation>缺失 %1</translation>
    </message>
    <message>
        <source>%1 extra</source>
        <translation>多余 %1</translation>
    </message>
    <message>
        <source>%1 hit too often</source>
        <translation>命中过多 %1</translation>
    </message>
    <message>
        <source>%1 hit too seldom</source>
        <translation>命中过少 %1</translation>
    </message>
    <message>
        <source>%1 show another face</source>
        <translation>%1 个像素显示了别的面</translation>
    </message>
    <message>
        <source>expect %1 %2: found %3</source>
        <translation>要求 %1 %2，实为 %3</translation>
    </message>
    <message>
        <source>a depth is %1 off</source>
        <translation>有一处深度相差 %1</translation>
    </message>
    <message>
        <source>a colour is %1 steps off</source>
        <translation>有一处颜色相差 %1 级</translation>
    </message>
    <message>
        <source>%1 differ, all closer to a true edge than snapping may move it</source>
        <translation>%1 个像素不同，但都离真实的边很近，没有超出对齐可能造成的移动</translation>
    </message>
    <message>
        <source>%1 show another face, closer to the right one than depths are told apart</source>
        <translation>%1 个像素显示了别的面，但其深度与正确的面近得无法分辨</translation>
    </message>
    <message>
        <source>, </source>
        <translation>，</translation>
    </message>
    <message>
        <source>Four triangles meet on the centre pixel of 9 x 9 and share the diagonals through 17 centres: every pixel exactly once.</source>
        <translation>四个三角形相交于 9 x 9 的中心像素，公共对角线穿过 17 个像素中心：每个像素恰好一次。</translation>
    </message>
    <message>
        <source>A centre on an edge belongs to the face right of it or below it (top-left rule), whoever is drawn first.</source>
        <translation>落在边上的中心属于边右侧或下方的面（左上规则），与绘制先后无关。</translation>
    </message>
    <message>
        <source>Horizontal edges run through the centres of rows 1, 3, 5: the row belongs to the strip below (top edge).</source>
        <translation>水平边穿过第 1、3、5 行的中心：该行属于下方的条带（上边）。</translation>
    </message>
    <message>
        <source>Vertical edges run through the centres of columns 1, 3, 5: the column belongs to the strip on the right (left edge).</source>
        <translation>竖直边穿过第 1、3、5 列的中心：该列属于右侧的条带（左边）。</translation>
    </message>
    <message>
        <source>An edge of slope 1:2 runs through 8 pixel centres of 16 x 16: each belongs to one side only.</source>
        <translation>斜率 1:2 的边穿过 16 x 16 的 8 个像素中心：每个中心只属于一侧。</translation>
    </message>
    <message>
        <source>An edge of slope 1:4 runs through 4 pixel centres of 16 x 16: each belongs to one side only.</source>
        <translation>斜率 1:4 的边穿过 16 x 16 的 4 个像素中心：每个中心只属于一侧。</translation>
    </message>
    <message>
        <source>An edge of slope -1:2 runs through 8 pixel centres of 16 x 16: each belongs to one side only.</source>
        <translation>斜率 -1:2 的边穿过 16 x 16 的 8 个像素中心：每个中心只属于一侧。</translation>
    </message>
    <message>
        <source>An edge of slope 3:4 runs through 4 pixel centres of 16 x 16: each belongs to one side only.</source>
        <translation>斜率 3:4 的边穿过 16 x 16 的 4 个像素中心：每个中心只属于一侧。</translation>
    </message>
    <message>
        <source>An edge of slope -1:8 runs through 2 pixel centres of 16 x 16: each belongs to one side only.</source>
        <translation>斜率 -1:8 的边穿过 16 x 16 的 2 个像素中心：每个中心只属于一侧。</translation>
    </message>
    <message>
        <source>A net of quads with every corner on a pixel centre and alternating diagonals: each pixel inside once.</source>
        <translation>由四边形组成的网格，每个角都在像素中心，对角线交替：内部每个像素恰好一次。</translation>
    </message>
    <message>
        <source>A triangle strip whose faces wind both ways, all edges through centres: winding must not decide who owns an edge.</source>
        <translation>三角形带，各面环绕方向不一，所有边都穿过中心：边归谁不得由环绕方向决定。</translation>
    </message>
    <message>
        <source>The shared edge lies 1/256 px below a row of centres: the row belongs to the upper face.</source>
        <translation>公共边在一行中心下方 1/256 像素：该行属于上面的面。</translation>
    </message>
    <message>
        <source>The shared edge lies 1/256 px left of a column of centres: the column belongs to the right face.</source>
        <translation>公共边在一列中心左侧 1/256 像素：该列属于右面的面。</translation>
    </message>
    <message>
        <source>The same face with its corners in all six orders: each covers the same pixels.</source>
        <translation>同一个面，三个角的六种排列：每次覆盖相同的像素。</translation>
    </message>
    <message>
        <source>Nine faces round a hub on a pixel centre: the hub pixel and all others exactly once.</source>
        <translation>九个面围绕位于像素中心的轴点：轴点像素和其他像素都恰好一次。</translation>
    </message>
    <message>
        <source>Many edges meet in one point; a rule that looks at one edge at a time must still add up to one.</source>
        <translation>许多边相交于一点；每次只看一条边的规则合起来仍必须恰好为一次。</translation>
    </message>
    <message>
        <source>A fan whose hub lies on a pixel corner: every pixel exactly once.</source>
        <translation>轴点在像素角上的扇形：每个像素恰好一次。</translation>
    </message>
    <message>
        <source>Every other face of a fan winds the other way: every pixel exactly once.</source>
        <translation>扇形中每隔一个面环绕方向相反：每个像素恰好一次。</translation>
    </message>
    <message>
        <source>A fan of narrow faces round a hub 1/256 px right of and above a centre: every pixel exactly once.</source>
        <translation>窄面组成的扇形，轴点在某中心右上方 1/256 像素：每个像素恰好一次。</translation>
    </message>
    <message>
        <source>96 slivers meet in one point of a 32 x 32 viewport: every pixel exactly once.</source>
        <translation>96 个细长三角形在 32 x 32 视口中相交于一点：每个像素恰好一次。</translation>
    </message>
    <message>
        <source>A fan whose hub lies on the left border of the viewport at the height of a centre.</source>
        <translation>轴点在视口左边界上、与某像素中心同高的扇形。</translation>
    </message>
    <message>
        <source>A 24-gon as a fan from one of its corners: covered pixels once, no hole.</source>
        <translation>从一个角出发的扇形组成的正二十四边形：覆盖的像素各一次，没有洞。</translation>
    </message>
    <message>
        <source>A sliver 1/256 px wide just right of a column of centres covers nothing.</source>
        <translation>紧挨一列中心右侧、宽 1/256 像素的细条什么也不覆盖。</translation>
    </message>
    <message>
        <source>Too thin to hold a centre inside; only a centre on a left or top edge counts.</source>
        <translation>太细，内部容不下中心；只有落在左边或上边上的中心才算。</translation>
    </message>
    <message>
        <source>A sliver 1/256 px wide whose left edge is on the centres covers the column.</source>
        <translation>宽 1/256 像素、左边落在中心上的细条覆盖这一列。</translation>
    </message>
    <message>
        <source>A sliver 1/256 px wide whose right edge is on the centres covers nothing: a right edge does not own its points.</source>
        <translation>宽 1/256 像素、右边落在中心上的细条什么也不覆盖：右边不拥有其上的点。</translation>
    </message>
    <message>
        <source>A sliver 2/256 px wide round the centres covers the column.</source>
        <translation>宽 2/256 像素、夹住中心的细条覆盖这一列。</translation>
    </message>
    <message>
        <source>A sliver 1/256 px high whose upper edge is on the centres covers the row (top edge).</source>
        <translation>高 1/256 像素、上边落在中心上的细条覆盖这一行（上边）。</translation>
    </message>
    <message>
        <source>A sliver 1/256 px high whose lower edge is on the centres covers nothing.</source>
        <translation>高 1/256 像素、下边落在中心上的细条什么也不覆盖。</translation>
    </message>
    <message>
        <source>64 slivers of 1/256 px side by side across a column of centres, and a quad on either side: watertight.</source>
        <translation>64 个宽 1/256 像素的细条并排跨过一列中心，两侧各一个四边形：严丝合缝。</translation>
    </message>
    <message>
        <source>Two slivers on either side of the diagonal through the centres: only the one that has it as its left edge is drawn.</source>
        <translation>穿过中心的对角线两侧各一个细条：只画以它为左边的那个。</translation>
    </message>
    <message>
        <source>A face 16 px long and 2/256 px wide at its far end, tip on a centre.</source>
        <translation>长 16 像素、远端宽 2/256 像素的面，尖端在像素中心。</translation>
    </message>
    <message>
        <source>A needle 4096 px long and 1/2 px wide at its foot, seen through a window near its foot: one pixel a row.</source>
        <translation>长 4096 像素、底宽 1/2 像素的针，从底部附近的窗口看：每行一个像素。</translation>
    </message>
    <message>
        <source>Long edges need the most bits: the error of a rounded slope grows with the distance.</source>
        <translation>长边需要的位数最多：斜率舍入的误差随距离增大。</translation>
    </message>
    <message>
        <source>A needle 16384 px long and 1/256 px wide with a centre on its left edge every 64 px.</source>
        <translation>长 16384 像素、宽 1/256 像素的针，左边上每 64 像素有一个中心。</translation>
    </message>
    <message>
        <source>Two needles point at one pixel centre from above and from below: the tip belongs to neither, since what lies right of it belongs to neither.</source>
        <translation>两根针从上下指向同一个像素中心：尖端不属于任何一根，因为它右侧不属于任何一根。</translation>
    </message>
    <message>
        <source>Sixteen needles from the rim to one pixel centre: their common tip is hit once, by the needle on its right.</source>
        <translation>十六根针从边缘指向同一个像素中心：公共尖端只命中一次，归其右侧的针。</translation>
    </message>
    <message>
        <source>Four faces round the screen centre reach out to 1e9: every pixel exactly once.</source>
        <translation>围绕屏幕中心的四个面伸展到 1e9：每个像素恰好一次。</translation>
    </message>
    <message>
        <source>Far corners must be cut before anything is rounded to a fixed grid.</source>
        <translation>远处的角必须先裁剪，再对齐到固定网格。</translation>
    </message>
    <message>
        <source>Four faces round the screen centre reach out to 1e20: every pixel exactly once.</source>
        <translation>围绕屏幕中心的四个面伸展到 1e20：每个像素恰好一次。</translation>
    </message>
    <message>
        <source>Four faces round the screen centre reach out to 3e38: every pixel exactly once.</source>
        <translation>围绕屏幕中心的四个面伸展到 3e38：每个像素恰好一次。</translation>
    </message>
    <message>
        <source>One edge of slope 1:2 through the viewport, its ends at 1e9, must not move: 1 px is 1e-8 of its length.</source>
        <translation>斜率 1:2 的边穿过视口，两端在 1e9，不得移动：1 像素只是其长度的 1e-8。</translation>
    </message>
    <message>
        <source>All three corners are near the largest float32: the viewport is covered once.</source>
        <translation>三个角都接近最大的 float32：视口被覆盖一次。</translation>
    </message>
    <message>
        <source>A corner at 1e-30, one at 1 and one at 1e30 in clip space with w alike: their screen positions are ordinary.</source>
        <translation>裁剪空间中三个角分别在 1e-30、1 和 1e30，w 也相应：屏幕位置是普通的。</translation>
    </message>
    <message>
        <source>Corners with w = 1e30 and coordinates of that size: an ordinary face.</source>
        <translation>w = 1e30、坐标同样大小的角：一个普通的面。</translation>
    </message>
    <message>
        <source>Two faces share an edge that leaves the viewport at both ends at 1e6: no pixel twice, none missed.</source>
        <translation>两个面的公共边两端都伸出视口到 1e6：像素不重复也不遗漏。</translation>
    </message>
    <message>
        <source>Three collinear corners, the line runs through centres: nothing is drawn.</source>
        <translation>三个角共线，直线穿过中心：什么也不画。</translation>
    </message>
    <message>
        <source>Facing and coverage are those of the snapped corners; no area, no pixels.</source>
        <translation>朝向和覆盖由对齐后的角决定；没有面积就没有像素。</translation>
    </message>
    <message>
        <source>Faces of one or two distinct points draw nothing.</source>
        <translation>只有一个或两个不同点的面什么也不画。</translation>
    </message>
    <message>
        <source>A face smaller than a snapping step round a pixel centre vanishes on snapping.</source>
        <translation>像素中心周围小于一个对齐步长的面，对齐后消失。</translation>
    </message>
    <message>
        <source>A face 7 px long and 1/1024 px high round a row of centres vanishes on snapping.</source>
        <translation>一行中心周围长 7 像素、高 1/1024 像素的面，对齐后消失。</translation>
    </message>
    <message>
        <source>The same kind of face without snapping: it covers the centres it holds.</source>
        <translation>同样的面不做对齐：覆盖它包含的中心。</translation>
    </message>
    <message>
        <source>Three corners exactly on one line snap to a triangle that holds two centres: what is drawn is the snapped face.</source>
        <translation>恰好共线的三个角对齐成了包含两个中心的三角形：画的是对齐后的面。</translation>
    </message>
    <message>
        <source>A degenerate face across the viewport with its ends at 1e9 draws nothing.</source>
        <translation>横穿视口、两端在 1e9 的退化面什么也不画。</translation>
    </message>
    <message>
        <source>NaN in x, y, z or w of one corner drops the face, the good face between them stays.</source>
        <translation>某个角的 x、y、z 或 w 为 NaN 时丢弃该面，夹在中间的正常面保留。</translation>
    </message>
    <message>
        <source>A comparison with NaN is false either way; such a face is dropped and counted.</source>
        <translation>与 NaN 的比较总为假；这样的面被丢弃并计数。</translation>
    </message>
    <message>
        <source>Inf and -Inf in x, y, z or w drop the face.</source>
        <translation>x、y、z 或 w 为 Inf 或 -Inf 时丢弃该面。</translation>
    </message>
    <message>
        <source>Infinity times zero is NaN; such a face is dropped and counted.</source>
        <translation>无穷乘以零是 NaN；这样的面被丢弃并计数。</translation>
    </message>
    <message>
        <source>A face of nothing but NaN, one of nothing but Inf, and a good one.</source>
        <translation>一个面全是 NaN，一个全是 Inf，一个正常。</translation>
    </message>
    <message>
        <source>w = Inf does not put a corner on the screen centre: the face is dropped.</source>
        <translation>w = Inf 并不会把角放到屏幕中心：该面被丢弃。</translation>
    </message>
    <message>
        <source>Corners at the largest float32 in all four coordinates are finite: the face is ordinary.</source>
        <translation>四个坐标都是最大的 float32 的角仍是有限的：这个面是普通的。</translation>
    </message>
    <message>
        <source>Finite, but any sum of two coordinates overflows in float32.</source>
        <translation>有限，但任意两个坐标之和在 float32 中溢出。</translation>
    </message>
    <message>
        <source>Clip coordinates of a few times 2^-149, the smallest float32: an ordinary face.</source>
        <translation>裁剪坐标只有最小 float32（2^-149）的几倍：一个普通的面。</translation>
    </message>
    <message>
        <source>Scaling x, y, z and w together changes nothing, however small they get.</source>
        <translation>同时缩放 x、y、z、w 不改变任何东西，无论多小。</translation>
    </message>
    <message>
        <source>w is denormal and so are x and y; flushing to zero would make w = 0.</source>
        <translation>w、x、y 都是非规格化数；若冲刷为零，就会得到 w = 0。</translation>
    </message>
    <message>
        <source>One corner is 2^-149 right of the screen centre: it snaps to it.</source>
        <translation>一个角在屏幕中心右侧 2^-149：对齐到屏幕中心。</translation>
    </message>
    <message>
        <source>-0 behaves like 0 in every coordinate.</source>
        <translation>任何坐标中的 -0 都等同于 0。</translation>
    </message>
    <message>
        <source>The sign of a zero means nothing.</source>
        <translation>零的符号没有意义。</translation>
    </message>
    <message>
        <source>w = -0 is w = 0: the corner is at infinity, the face is clipped.</source>
        <translation>w = -0 就是 w = 0：角在无穷远，面被裁剪。</translation>
    </message>
    <message>
        <source>The corner in the middle of the long edge lies exactly on it: no crack, no overlap.</source>
        <translation>长边中间的角恰好在边上：没有裂缝，也没有重叠。</translation>
    </message>
    <message>
        <source>A corner on a neighbour&apos;s edge is only safe if the grid can hold it exactly on the edge.</source>
        <translation>邻面边上的角只有在网格能让它恰好落在边上时才安全。</translation>
    </message>
    <message>
        <source>The corner lies 1/256 px right of the long edge: the crack is real and swallows the two centres in it.</source>
        <translation>角在长边右侧 1/256 像素：裂缝真实存在，吞掉其中两个中心。</translation>
    </message>
    <message>
        <source>The corner lies 2/256 px left of the long edge: the one centre in the overlap is covered twice.</source>
        <translation>角在长边左侧 2/256 像素：重叠处的一个中心被覆盖两次。</translation>
    </message>
    <message>
        <source>The corner of the crack, with the long edge split there: every pixel once.</source>
        <translation>裂缝处的角，长边也在那里断开：每个像素一次。</translation>
    </message>
    <message>
        <source>Corners exactly on x = -w and x = w: no cut, the borders belong to the picture.</source>
        <translation>角恰好在 x = -w 和 x = w 上：不切割，边界属于画面。</translation>
    </message>
    <message>
        <source>The planes of the clip volume belong to it: on a plane is inside.</source>
        <translation>裁剪体的平面属于裁剪体：在平面上即在内部。</translation>
    </message>
    <message>
        <source>All corners on the near plane z = -w: inside, depth exactly 0.</source>
        <translation>所有角都在近平面 z = -w 上：在内部，深度恰为 0。</translation>
    </message>
    <message>
        <source>All corners on the far plane z = w: inside, but depth 1 is not less than the cleared 1.</source>
        <translation>所有角都在远平面 z = w 上：在内部，但深度 1 不小于清除值 1。</translation>
    </message>
    <message>
        <source>All corners on the far plane: with lequal depth 1 passes against the cleared 1.</source>
        <translation>所有角都在远平面上：用 lequal 时深度 1 能通过与清除值 1 的比较。</translation>
    </message>
    <message>
        <source>An edge on the near plane, the third corner behind it: only the edge is left, nothing is drawn.</source>
        <translation>一条边在近平面上，第三个角在其后：只剩下这条边，什么也不画。</translation>
    </message>
    <message>
        <source>One corner on the near plane, one before and one behind it: three corners are left.</source>
        <translation>一个角在近平面上，一个在前，一个在后：剩下三个角。</translation>
    </message>
    <message>
        <source>A corner in the corner of the volume (w, w, w).</source>
        <translation>一个角位于裁剪体的角 (w, w, w)。</translation>
    </message>
    <message>
        <source>A face one float32 step beyond x = -w at w = 1: cut, no column lost.</source>
        <translation>在 w = 1 处超出 x = -w 一个 float32 步长的面：被切割，不丢任何一列。</translation>
    </message>
    <message>
        <source>A cut close to a corner gives a very short edge.</source>
        <translation>靠近角的切割会产生极短的边。</translation>
    </message>
    <message>
        <source>A corner at infinity above: the face is a strip that leaves the screen at the top.</source>
        <translation>一个角在上方无穷远：面成为一条从屏幕顶部伸出的带子。</translation>
    </message>
    <message>
        <source>w &gt; 0 is what is in front of the eye; dividing by any other w mirrors or explodes.</source>
        <translation>w &gt; 0 才在眼睛前方；除以其他 w 会镜像或爆炸。</translation>
    </message>
    <message>
        <source>Two corners at infinity: a wedge that opens to the right.</source>
        <translation>两个角在无穷远：向右张开的楔形。</translation>
    </message>
    <message>
        <source>All corners at infinity: nothing is inside w &gt; 0.</source>
        <translation>所有角都在无穷远：没有任何部分在 w &gt; 0 内。</translation>
    </message>
    <message>
        <source>A corner at (0, 0, 0, 0): the face is seen edge-on and draws nothing.</source>
        <translation>一个角在 (0, 0, 0, 0)：面正好侧对眼睛，什么也不画。</translation>
    </message>
    <message>
        <source>Two faces share an edge to a corner at infinity: no pixel twice, none missed.</source>
        <translation>两个面的公共边通向无穷远的角：像素不重复也不遗漏。</translation>
    </message>
    <message>
        <source>One corner behind the eye: the face goes on beyond the other two, not between.</source>
        <translation>一个角在眼睛后面：面在另两个角之外延伸，而不是在它们之间。</translation>
    </message>
    <message>
        <source>Two corners behind the eye.</source>
        <translation>两个角在眼睛后面。</translation>
    </message>
    <message>
        <source>All corners behind the eye: nothing, though the divide would give an ordinary face.</source>
        <translation>所有角都在眼睛后面：什么也没有，尽管做除法会得到一个普通的面。</translation>
    </message>
    <message>
        <source>A corner with w = -1e-30: just behind the eye.</source>
        <translation>一个角的 w = -1e-30：刚好在眼睛后面。</translation>
    </message>
    <message>
        <source>Two faces across w = 0, one front and one back: culling after clipping keeps the front one.</source>
        <translation>两个面跨过 w = 0，一正一反：裁剪后再剔除会保留正面。</translation>
    </message>
    <message>
        <source>Every corner is outside, none beyond the same plane; the viewport is covered.</source>
        <translation>每个角都在外面，但不在同一平面之外；视口被覆盖。</translation>
    </message>
    <message>
        <source>Testing corners is not enough: a face may cross the view with all corners outside.</source>
        <translation>只检查角是不够的：所有角都在外面的面也可能穿过视野。</translation>
    </message>
    <message>
        <source>Corners outside two planes each, the face passes the viewport corner without touching it: clipped to nothing.</source>
        <translation>每个角都在两个平面之外，面从视口角旁经过而不相碰：裁剪后什么也不剩。</translation>
    </message>
    <message>
        <source>The same, but the face cuts the corner of the viewport.</source>
        <translation>同上，但面切过视口的角。</translation>
    </message>
    <message>
        <source>Six faces, each beyond one plane of the volume: nothing.</source>
        <translation>六个面，各在裁剪体的一个平面之外：什么也没有。</translation>
    </message>
    <message>
        <source>The plane of the face runs through the eye: edge-on, nothing.</source>
        <translation>面所在的平面穿过眼睛：正好侧对，什么也没有。</translation>
    </message>
    <message>
        <source>A face seen edge-on has no area on the screen, one nearly so has very little.</source>
        <translation>正好侧对的面在屏幕上没有面积，近乎侧对的面积极小。</translation>
    </message>
    <message>
        <source>A face through the eye with a corner behind it: still edge-on.</source>
        <translation>穿过眼睛且有一个角在其后的面：仍是侧对。</translation>
    </message>
    <message>
        <source>The floor 1e-6 below the eye, from the near plane to w = 1000: one row of pixels at most.</source>
        <translation>眼睛下方 1e-6 的地面，从近平面到 w = 1000：最多一行像素。</translation>
    </message>
    <message>
        <source>Corners with w of 1e-6 and 1e-7: large coordinates after the divide.</source>
        <translation>w 为 1e-6 和 1e-7 的角：除法之后坐标很大。</translation>
    </message>
    <message>
        <source>Sixteen strips of two planes at z and z(1 + 2^-k), k = 2..17; near 0.1, far 100, z 50, float32: so many strips show the front plane.</source>
        <translation>十六条带，每条两个平面在 z 和 z(1 + 2^-k)，k = 2..17；近 0.1，远 100，z 50，float32：有这么多条带显示前面的平面。</translation>
    </message>
    <message>
        <source>z/w crowds towards the far plane; the format of the depth buffer decides what stays apart.</source>
        <translation>z/w 向远平面聚集；深度缓冲的格式决定还能分辨什么。</translation>
    </message>
    <message>
        <source>Sixteen strips of two planes at z and z(1 + 2^-k), k = 2..17; near 0.1, far 100, z 50, unorm24: so many strips show the front plane.</source>
        <translation>十六条带，每条两个平面在 z 和 z(1 + 2^-k)，k = 2..17；近 0.1，远 100，z 50，unorm24：有这么多条带显示前面的平面。</translation>
    </message>
    <message>
        <source>Sixteen strips of two planes at z and z(1 + 2^-k), k = 2..17; near 0.1, far 100, z 50, unorm16: so many strips show the front plane.</source>
        <translation>十六条带，每条两个平面在 z 和 z(1 + 2^-k)，k = 2..17；近 0.1，远 100，z 50，unorm16：有这么多条带显示前面的平面。</translation>
    </message>
    <message>
        <source>Sixteen strips of two planes at z and z(1 + 2^-k), k = 2..17; near 0.1, far 10000, z 1000, float32: so many strips show the front plane.</source>
        <translation>十六条带，每条两个平面在 z 和 z(1 + 2^-k)，k = 2..17；近 0.1，远 10000，z 1000，float32：有这么多条带显示前面的平面。</translation>
    </message>
    <message>
        <source>Sixteen strips of two planes at z and z(1 + 2^-k), k = 2..17; near 0.1, far 10000, z 1000, unorm24: so many strips show the front plane.</source>
        <translation>十六条带，每条两个平面在 z 和 z(1 + 2^-k)，k = 2..17；近 0.1，远 10000，z 1000，unorm24：有这么多条带显示前面的平面。</translation>
    </message>
    <message>
        <source>Sixteen strips of two planes at z and z(1 + 2^-k), k = 2..17; near 0.1, far 10000, z 1000, unorm16: so many strips show the front plane.</source>
        <translation>十六条带，每条两个平面在 z 和 z(1 + 2^-k)，k = 2..17；近 0.1，远 10000，z 1000，unorm16：有这么多条带显示前面的平面。</translation>
    </message>
    <message>
        <source>Sixteen strips of two planes at z and z(1 + 2^-k), k = 2..17; near 1e-05, far 1e+06, z 1, float32: so many strips show the front plane.</source>
        <translation>十六条带，每条两个平面在 z 和 z(1 + 2^-k)，k = 2..17；近 1e-05，远 1e+06，z 1，float32：有这么多条带显示前面的平面。</translation>
    </message>
    <message>
        <source>Sixteen strips of two planes at z and z(1 + 2^-k), k = 2..17; near 1e-05, far 1e+06, z 1, unorm24: so many strips show the front plane.</source>
        <translation>十六条带，每条两个平面在 z 和 z(1 + 2^-k)，k = 2..17；近 1e-05，远 1e+06，z 1，unorm24：有这么多条带显示前面的平面。</translation>
    </message>
    <message>
        <source>Sixteen strips of two planes at z and z(1 + 2^-k), k = 2..17; near 1e-05, far 1e+06, z 1, unorm16: so many strips show the front plane.</source>
        <translation>十六条带，每条两个平面在 z 和 z(1 + 2^-k)，k = 2..17；近 1e-05，远 1e+06，z 1，unorm16：有这么多条带显示前面的平面。</translation>
    </message>
    <message>
        <source>Sixteen strips of two planes at z and z(1 + 2^-k), k = 2..17; reversed z in the 0..w range keeps float32 apart.</source>
        <translation>十六条带，每条两个平面在 z 和 z(1 + 2^-k)，k = 2..17；0..w 范围的反向 z 让 float32 仍能分辨。</translation>
    </message>
    <message>
        <source>Sixteen strips of two planes at z and z(1 + 2^-k), k = 2..17; reversed z in the -w..w range.</source>
        <translation>十六条带，每条两个平面在 z 和 z(1 + 2^-k)，k = 2..17；-w..w 范围的反向 z。</translation>
    </message>
    <message>
        <source>Sixteen strips of two planes at z and z(1 + 2^-k), k = 2..17; far / near = 1e11: what clip space in float32 still tells apart.</source>
        <translation>十六条带，每条两个平面在 z 和 z(1 + 2^-k)，k = 2..17；远 / 近 = 1e11：float32 的裁剪空间还能分辨多少。</translation>
    </message>
    <message>
        <source>Sixteen strips of two planes at z and z(1 + 2^-k), k = 2..17; far / near = 1e11, reversed in 0..w: the exact depths stay apart.</source>
        <translation>十六条带，每条两个平面在 z 和 z(1 + 2^-k)，k = 2..17；远 / 近 = 1e11，0..w 反向：精确深度仍能分辨。</translation>
    </message>
    <message>
        <source>Four planes within one step of unorm16, drawn from far to near: the first three take one code and the first of them stays, the fourth takes the next code and wins.</source>
        <translation>四个平面相差在 unorm16 的一个步长之内，由远到近绘制：前三个取同一编码，其中第一个保留，第四个取下一个编码而获胜。</translation>
    </message>
    <message>
        <source>Four planes within one step of unorm24, drawn from far to near: the first three take one code and the first of them stays, the fourth takes the next code and wins.</source>
        <translation>四个平面相差在 unorm24 的一个步长之内，由远到近绘制：前三个取同一编码，其中第一个保留，第四个取下一个编码而获胜。</translation>
    </message>
    <message>
        <source>The same face twice: with less the first one stays.</source>
        <translation>同一个面画两次：用 less 时保留第一个。</translation>
    </message>
    <message>
        <source>Equal depths are decided by the test and the order alone; interpolation must not add noise.</source>
        <translation>深度相等时只由比较方式和顺序决定；插值不得带来噪声。</translation>
    </message>
    <message>
        <source>The same face twice: with lequal the second one wins every pixel.</source>
        <translation>同一个面画两次：用 lequal 时第二个赢得所有像素。</translation>
    </message>
    <message>
        <source>A slanted quad twice with either diagonal; all corners exactly in one plane: less must keep the first pair.</source>
        <translation>倾斜的四边形用两条对角线各画一次，所有角恰好共面：less 必须保留第一对。</translation>
    </message>
    <message>
        <source>A small face in the plane of a large one, drawn after it with lequal: it shows everywhere it covers.</source>
        <translation>大面所在平面内的小面，随后用 lequal 绘制：覆盖之处处处可见。</translation>
    </message>
    <message>
        <source>Two quads cross along a column of centres, where their depths are equal: less keeps the first there.</source>
        <translation>两个四边形沿一列中心相交，那里深度相等：less 保留第一个。</translation>
    </message>
    <message>
        <source>Where two faces cross, the winner changes along a line that no corner knows.</source>
        <translation>两个面相交处，胜者沿一条任何角都不知道的线改变。</translation>
    </message>
    <message>
        <source>Three faces that overlap in a ring: each is in front of the next and behind the one before.</source>
        <translation>三个面循环重叠：每个都在下一个之前、上一个之后。</translation>
    </message>
    <message>
        <source>A wall pierces a floor seen in perspective: the line where they meet is that of exact depths.</source>
        <translation>透视中墙穿过地面：交线由精确深度决定。</translation>
    </message>
    <message>
        <source>Two planes one float32 step of clip z apart, the nearer drawn last: exact depths let it win everywhere.</source>
        <translation>两个平面的裁剪 z 相差一个 float32 步长，近的后画：精确深度让它处处获胜。</translation>
    </message>
    <message>
        <source>Two planes 2^-149 of clip z apart at z = 0: no finite format after the divide keeps them apart, exact depths do.</source>
        <translation>两个平面在 z = 0 处的裁剪 z 相差 2^-149：除法之后没有任何有限格式能分辨，精确深度可以。</translation>
    </message>
    <message>
        <source>With greater the buffer starts at 0 and the farther face wins.</source>
        <translation>用 greater 时缓冲从 0 开始，较远的面获胜。</translation>
    </message>
    <message>
        <source>Without a depth test the last face wins, near or far.</source>
        <translation>没有深度测试时最后画的面获胜，无论远近。</translation>
    </message>
    <message>
        <source>Depth 0 in front of a face, and depth 1 against the cleared buffer.</source>
        <translation>深度 0 在一个面之前，深度 1 对比清除后的缓冲。</translation>
    </message>
    <message>
        <source>A floor from w = 1 to w = 10, red runs from 0 at its near edge to 1 at its far one: colours are those of the true perspective.</source>
        <translation>从 w = 1 到 w = 10 的地面，红色从近边的 0 变到远边的 1：颜色符合真实透视。</translation>
    </message>
    <message>
        <source>Colours are linear in space, not on the screen: interpolate c/w and 1/w.</source>
        <translation>颜色在空间中是线性的，在屏幕上不是：应插值 c/w 和 1/w。</translation>
    </message>
    <message>
        <source>A floor from w = 1 to w = 100, red runs from 0 at its near edge to 1 at its far one: colours are those of the true perspective.</source>
        <translation>从 w = 1 到 w = 100 的地面，红色从近边的 0 变到远边的 1：颜色符合真实透视。</translation>
    </message>
    <message>
        <source>A floor from w = 1 to w = 1000, red runs from 0 at its near edge to 1 at its far one: colours are those of the true perspective.</source>
        <translation>从 w = 1 到 w = 1000 的地面，红色从近边的 0 变到远边的 1：颜色符合真实透视。</translation>
    </message>
    <message>
        <source>A floor from w = 1 to w = 10000, red runs from 0 at its near edge to 1 at its far one: colours are those of the true perspective.</source>
        <translation>从 w = 1 到 w = 10000 的地面，红色从近边的 0 变到远边的 1：颜色符合真实透视。</translation>
    </message>
    <message>
        <source>A constant colour over w from 1 to 10000 stays what it is in every pixel.</source>
        <translation>w 从 1 到 10000，常数颜色在每个像素中保持不变。</translation>
    </message>
    <message>
        <source>Three corners with w = 1, 4 and 64: red, green and blue mix with the weights of the true perspective.</source>
        <translation>三个角的 w 为 1、4 和 64：红绿蓝按真实透视的权重混合。</translation>
    </message>
    <message>
        <source>A floor that goes on behind the eye: colours in front are not pulled by the corner behind.</source>
        <translation>延伸到眼睛后面的地面：前方的颜色不受后面的角影响。</translation>
    </message>
    <message>
        <source>With equal w the perspective-correct colour is the affine one.</source>
        <translation>w 相等时，透视校正的颜色就是仿射插值的颜色。</translation>
    </message>
    <message>
        <source>At one pixel of a 4096 viewport the edge value is one unit of 1/65536 px^2 on the inside: covered. float32 cannot tell.</source>
        <translation>在 4096 视口的某个像素，边函数值在内侧只有一个单位（1/65536 像素²）：被覆盖。float32 分辨不出。</translation>
    </message>
    <message>
        <source>The difference of two products of 24-bit numbers needs more bits than float32 or a careless float64 has.</source>
        <translation>两个 24 位数乘积之差所需的位数，超过 float32 或随意使用的 float64。</translation>
    </message>
    <message>
        <source>At one pixel of a 4096 viewport the edge value is one unit of 1/65536 px^2 on the outside: not covered.</source>
        <translation>在 4096 视口的某个像素，边函数值在外侧只有一个单位（1/65536 像素²）：不被覆盖。</translation>
    </message>
    <message>
        <source>At one pixel of a 4096 viewport the edge value is exactly 0 far from its ends; the left edge owns its points.</source>
        <translation>在 4096 视口的某个像素，远离端点处的边函数值恰为 0；左边拥有其上的点。</translation>
    </message>
    <message>
        <source>A face of 8 x 8 px at the far end of 16384 px: its edges need the low bits of large coordinates.</source>
        <translation>16384 像素远端的 8 x 8 像素的面：它的边需要大坐标的低位。</translation>
    </message>
    <message>
        <source>An edge that falls by 3 px over 16384: adding its slope step by step in float32 leaves it.</source>
        <translation>在 16384 像素上下降 3 像素的边：用 float32 逐步累加斜率会偏离它。</translation>
    </message>
    <message>
        <source>Errors of a running sum grow with the number of steps.</source>
        <translation>累加的误差随步数增大。</translation>
    </message>
    <message>
        <source>An edge that moves 5 px to the right over 16384 rows.</source>
        <translation>在 16384 行中右移 5 像素的边。</translation>
    </message>
    <message>
        <source>Red runs from 0 to 1 over 10000 px: the last pixels tell how far a running sum has drifted.</source>
        <translation>红色在 10000 像素内从 0 变到 1：最后的像素显示累加漂移了多少。</translation>
    </message>
    <message>
        <source>Depth runs from 0 to 1 over 16384 px: depth is linear on the screen to the last pixel.</source>
        <translation>深度在 16384 像素内从 0 变到 1：直到最后一个像素都在屏幕上线性。</translation>
    </message>
    <message>
        <source>A face that every plane of the volume cuts: nine corners are left.</source>
        <translation>被裁剪体每个平面切到的面：剩下九个角。</translation>
    </message>
    <message>
        <source>Every plane may add a corner: three and six make nine.</source>
        <translation>每个平面最多增加一个角：三加六得九。</translation>
    </message>
    <message>
        <source>Nine corners with the near plane at z = 0.</source>
        <translation>近平面在 z = 0 时的九个角。</translation>
    </message>
    <message>
        <source>Eight corners are left.</source>
        <translation>剩下八个角。</translation>
    </message>
    <message>
        <source>A net larger than the viewport, w from 1 to 4 at random: cut by the side planes, still watertight.</source>
        <translation>大于视口的网格，w 在 1 到 4 之间随机：被侧面平面切割，仍严丝合缝。</translation>
    </message>
    <message>
        <source>Both faces of a shared edge must compute the same new corner where a plane cuts it.</source>
        <translation>平面切过公共边时，两侧的面必须算出同一个新角。</translation>
    </message>
    <message>
        <source>The same with every other cell wound the other way: still watertight.</source>
        <translation>同上，每隔一格环绕方向相反：仍严丝合缝。</translation>
    </message>
    <message>
        <source>A net that reaches 40 times the viewport.</source>
        <translation>伸展到视口 40 倍的网格。</translation>
    </message>
    <message>
        <source>A net that dips through the near plane: where it is left no pixel is hit twice.</source>
        <translation>穿过近平面的网格：剩余部分没有像素被重复命中。</translation>
    </message>
    <message>
        <source>A net that dips through the far plane: where it is left no pixel is hit twice.</source>
        <translation>穿过远平面的网格：剩余部分没有像素被重复命中。</translation>
    </message>
    <message>
        <source>A ground net from behind the eye to the distance: below the horizon no pixel is missed or hit twice.</source>
        <translation>从眼睛后面延伸到远方的地面网格：地平线以下没有像素遗漏或重复。</translation>
    </message>
    <message>
        <source>Two faces share the diagonal of a 1 x 1 viewport: every pixel exactly once.</source>
        <translation>两个面共用 1 x 1 视口的对角线：每个像素恰好一次。</translation>
    </message>
    <message>
        <source>Loops over blocks and tiles must end where the viewport ends.</source>
        <translation>按块和瓦片的循环必须在视口边界处结束。</translation>
    </message>
    <message>
        <source>Two faces share the diagonal of a 1 x 16384 viewport: every pixel exactly once.</source>
        <translation>两个面共用 1 x 16384 视口的对角线：每个像素恰好一次。</translation>
    </message>
    <message>
        <source>Two faces share the diagonal of a 3 x 5 viewport: every pixel exactly once.</source>
        <translation>两个面共用 3 x 5 视口的对角线：每个像素恰好一次。</translation>
    </message>
    <message>
        <source>Two faces share the diagonal of a 2 x 2 viewport: every pixel exactly once.</source>
        <translation>两个面共用 2 x 2 视口的对角线：每个像素恰好一次。</translation>
    </message>
    <message>
        <source>Two faces share the diagonal of a 17 x 13 viewport: every pixel exactly once.</source>
        <translation>两个面共用 17 x 13 视口的对角线：每个像素恰好一次。</translation>
    </message>
    <message>
        <source>Two faces share the diagonal of a 255 x 1 viewport: every pixel exactly once.</source>
        <translation>两个面共用 255 x 1 视口的对角线：每个像素恰好一次。</translation>
    </message>
    <message>
        <source>Two faces share the diagonal of a 127 x 63 viewport: every pixel exactly once.</source>
        <translation>两个面共用 127 x 63 视口的对角线：每个像素恰好一次。</translation>
    </message>
    <message>
        <source>Two faces share the diagonal of a 1 x 257 viewport: every pixel exactly once.</source>
        <translation>两个面共用 1 x 257 视口的对角线：每个像素恰好一次。</translation>
    </message>
    <message>
        <source>Two faces share the diagonal of a 16384 x 2 viewport: every pixel exactly once.</source>
        <translation>两个面共用 16384 x 2 视口的对角线：每个像素恰好一次。</translation>
    </message>
    <message>
        <source>Culling front faces keeps the clockwise one.</source>
        <translation>剔除正面后留下顺时针的面。</translation>
    </message>
    <message>
        <source>Facing is the sign of the snapped area after clipping.</source>
        <translation>朝向是裁剪并对齐后面积的符号。</translation>
    </message>
    <message>
        <source>A thin front face turns its back on snapping: culled by its snapped area.</source>
        <translation>细薄的正面对齐后翻成了背面：按对齐后的面积剔除。</translation>
    </message>
    <message>
        <source>A closed box drawn without culling: every pixel inside is covered by a front and a back face.</source>
        <translation>不剔除地画封闭盒子：内部每个像素被一个正面和一个背面覆盖。</translation>
    </message>
    <message>
        <source>The same box with back faces culled: every pixel inside exactly once.</source>
        <translation>同一个盒子剔除背面：内部每个像素恰好一次。</translation>
    </message>
    <message>
        <source>Corners halfway between two steps of 1/1 px round to the even one.</source>
        <translation>位于两个 1/1 像素步长正中的角舍入到偶数步。</translation>
    </message>
    <message>
        <source>Rounding half to even has no drift to either side.</source>
        <translation>半数取偶的舍入不会偏向任何一侧。</translation>
    </message>
    <message>
        <source>Corners halfway between two steps of 1/2 px round to the even one.</source>
        <translation>位于两个 1/2 像素步长正中的角舍入到偶数步。</translation>
    </message>
    <message>
        <source>Corners halfway between two steps of 1/4 px round to the even one.</source>
        <translation>位于两个 1/4 像素步长正中的角舍入到偶数步。</translation>
    </message>
    <message>
        <source>Corners halfway between two steps of 1/8 px round to the even one.</source>
        <translation>位于两个 1/8 像素步长正中的角舍入到偶数步。</translation>
    </message>
    <message>
        <source>Corners halfway between two steps of 1/32 px round to the even one.</source>
        <translation>位于两个 1/32 像素步长正中的角舍入到偶数步。</translation>
    </message>
    <message>
        <source>A net snapped to whole pixels: all its edges run along pixel corners, still watertight.</source>
        <translation>对齐到整像素的网格：所有边都沿像素角走，仍严丝合缝。</translation>
    </message>
    <message>
        <source>Edges 1/512 px beside the centres: one rounds onto them, the other a step further.</source>
        <translation>边在中心旁 1/512 像素：一条舍入到中心上，另一条再远一步。</translation>
    </message>
    <message>
        <source>Corners at thirds of a pixel, not snapped: the truth of the unsnapped face.</source>
        <translation>角在三分之一像素处，不对齐：未对齐的面的真值。</translation>
    </message>
    <message>
        <source>The truth without a grid; other renderers snap as usual.</source>
        <translation>不用网格的真值；其他渲染方式照常对齐。</translation>
    </message>
    <message>
        <source>A face whose snapped and unsnapped coverage differ; this is the unsnapped one.</source>
        <translation>对齐与不对齐覆盖不同的面；这里是不对齐的。</translation>
    </message>
    <message>
        <source>The same face snapped: its edges lie on the centres again.</source>
        <translation>同一个面对齐后：边又落在中心上。</translation>
    </message>
    <message>
        <source>The grid moves edges by up to 1/512 px.</source>
        <translation>网格使边最多移动 1/512 像素。</translation>
    </message>
    <message>
        <source>A face cut by the near plane, not snapped: the cut runs where z = -w exactly.</source>
        <translation>被近平面切割且不对齐的面：切口恰好在 z = -w 处。</translation>
    </message>
    <message>
        <source>4 samples a pixel: corners snap to pixels, not samples; border pixels mix face and background.</source>
        <translation>每像素 4 个样本：角按像素而不是按样本对齐；边界像素混合面与背景。</translation>
    </message>
    <message>
        <source>Samples lie at (i + 1/2) / N of a pixel.</source>
        <translation>样本位于像素的 (i + 1/2) / N 处。</translation>
    </message>
    <message>
        <source>9 samples a pixel: corners snap to pixels, not samples; border pixels mix face and background.</source>
        <translation>每像素 9 个样本：角按像素而不是按样本对齐；边界像素混合面与背景。</translation>
    </message>
    <message>
        <source>16 samples a pixel: corners snap to pixels, not samples; border pixels mix face and background.</source>
        <translation>每像素 16 个样本：角按像素而不是按样本对齐；边界像素混合面与背景。</translation>
    </message>
    <message>
        <source>Two faces of one colour share a diagonal under 16 samples a pixel: no seam in the colour.</source>
        <translation>同色的两个面共用对角线，每像素 16 个样本：颜色没有接缝。</translation>
    </message>
    <message>
        <source>With a 0..w range a face at z = 0 is on the near plane: inside, depth 0.</source>
        <translation>在 0..w 范围下，z = 0 的面在近平面上：在内部，深度 0。</translation>
    </message>
    <message>
        <source>The clip volume is 0 &lt;= z &lt;= w and depth is z/w.</source>
        <translation>裁剪体是 0 &lt;= z &lt;= w，深度是 z/w。</translation>
    </message>
    <message>
        <source>With a 0..w range a face at z = -w/2 is behind the near plane: nothing.</source>
        <translation>在 0..w 范围下，z = -w/2 的面在近平面后面：什么也没有。</translation>
    </message>
    <message>
        <source>A slanted face cut at z = 0; depth is z/w unchanged.</source>
        <translation>在 z = 0 处切割的倾斜面；深度仍是 z/w。</translation>
    </message>
    <message>
        <source>The background has a colour of its own; a black face on it counts as covered.</source>
        <translation>背景有自己的颜色；其上的黑色面算作覆盖。</translation>
    </message>
    <message>
        <source>A pixel is covered because a face covers it, not because its colour differs from the background.</source>
        <translation>像素被覆盖是因为有面覆盖它，而不是因为颜色与背景不同。</translation>
    </message>
    <message>
        <source>Three faces along edges that fall over 16384 px: float32 edge values, added up column by column, lose pixels at the end of a row.</source>
        <translation>三个面的边在 16384 像素内下降：float32 边函数值逐列累加，在行末丢失像素。</translation>
    </message>
    <message>
        <source>Evaluated anew at every pixel, float32 is right here: it is the running sum that drifts.</source>
        <translation>每个像素重新计算时 float32 在这里是对的：漂移的是累加。</translation>
    </message>
    <message>
        <source>Three faces along edges that rise over 16384 px: float32 edge values, added up column by column, take pixels of the neighbour.</source>
        <translation>三个面的边在 16384 像素内上升：float32 边函数值逐列累加，会占走邻面的像素。</translation>
    </message>
    <message>
        <source>Cutting and snapping to whole pixels fold this face over itself, round (6,4) (0,6) (15,3) (16,3): it covers its hull, once.</source>
        <translation>切割并对齐到整像素使这个面折叠，绕 (6,4) (0,6) (15,3) (16,3)：它覆盖自己的凸包，各一次。</translation>
    </message>
    <message>
        <source>No corner of the snapped outline sees all of it, so no fan of triangles covers it without hitting samples twice.</source>
        <translation>对齐后的轮廓没有一个角能看到全部，所以任何三角形扇都会重复命中样本。</translation>
    </message>
    <message>
        <source>A cut corner lies exactly half way between two points of the grid: it snaps to the even one.</source>
        <translation>切出的角恰好位于两个网格点正中：对齐到偶数点。</translation>
    </message>
    <message>
        <source>A cut corner that is rounded before it is snapped falls off the tie, to either side.</source>
        <translation>切出的角若在对齐之前先被舍入，就会偏离正中，落到任意一侧。</translation>
    </message>
    <message>
        <source>Two corners with w = 0, whole pixels: a tie of a cut corner decides seven pixels.</source>
        <translation>两个角的 w = 0，整像素：一个切出的角恰在边上时归谁，决定七个像素。</translation>
    </message>
    <message>
        <source>A corner behind the eye, and a cut corner exactly half way between two points of the grid.</source>
        <translation>一个角在眼睛后面，一个切出的角恰好位于两个网格点正中。</translation>
    </message>
    <message>
        <source>A tie of a cut corner, on an edge that ends at 10^7.</source>
        <translation>一条边的另一端在 10^7 处，切出的角恰好位于网格点正中。</translation>
    </message>
    <message>
        <source>Corners at 10^8 and whole pixels: 20 pixels, not 4.</source>
        <translation>位于 10^8 处的角，整像素：20 个像素，而不是 4 个。</translation>
    </message>
    <message>
        <source>A corner made by two planes is computed from the face itself: a cut of a rounded cut lands elsewhere.</source>
        <translation>由两个平面切出的角要从面本身算起：对已舍入的切点再切，会落到别处。</translation>
    </message>
    <message>
        <source>A corner at w = 10^10, cut at z = 0.</source>
        <translation>一个角的 w 为 10^10，在 z = 0 处裁剪。</translation>
    </message>
    <message>
        <source>Corners at 10^15, before and behind the eye.</source>
        <translation>位于 10^15 处的角，眼前眼后都有。</translation>
    </message>
    <message>
        <source>Corners at 10^15 on a finer grid.</source>
        <translation>位于 10^15 处的角，更细的网格。</translation>
    </message>
    <message>
        <source>No plane has all corners outside, yet nothing of the face is in the view volume.</source>
        <translation>没有哪个平面把所有角都隔在外面，可是面没有任何部分在视体之内。</translation>
    </message>
    <message>
        <source>Corners at 10^30, one with w = 0: 9 pixels, not 64.</source>
        <translation>位于 10^30 处的角，一个 w = 0：9 个像素，而不是 64 个。</translation>
    </message>
    <message>
        <source>Corners close to the largest float, one with w = 0 and one behind the eye.</source>
        <translation>角接近最大的浮点数，一个 w = 0，一个在眼睛后面。</translation>
    </message>
    <message>
        <source>Corners close to the largest float: almost a quarter of the screen, but for 29 pixels.</source>
        <translation>角接近最大的浮点数：将近四分之一个屏幕，只差 29 个像素。</translation>
    </message>
    <message>
        <source>A fan whose rim reaches the largest float, with w from 1/2 to 2 * 10^38: each pixel once.</source>
        <translation>边缘伸展到最大浮点数的扇形，w 从 1/2 到 2 * 10^38：每个像素一次。</translation>
    </message>
    <message>
        <source>edges four quarters</source>
        <translation>边：四等分</translation>
    </message>
    <message>
        <source>edges rows on centres</source>
        <translation>边：水平边过像素中心</translation>
    </message>
    <message>
        <source>edges columns on centres</source>
        <translation>边：竖直边过像素中心</translation>
    </message>
    <message>
        <source>edges slope half</source>
        <translation>边：斜率二分之一</translation>
    </message>
    <message>
        <source>edges slope quarter</source>
        <translation>边：斜率四分之一</translation>
    </message>
    <message>
        <source>edges slope minus half</source>
        <translation>边：斜率负二分之一</translation>
    </message>
    <message>
        <source>edges slope three quarters</source>
        <translation>边：斜率四分之三</translation>
    </message>
    <message>
        <source>edges slope minus eighth</source>
        <translation>边：斜率负八分之一</translation>
    </message>
    <message>
        <source>edges grid on centres</source>
        <translation>边：网格线过像素中心</translation>
    </message>
    <message>
        <source>edges strip both windings</source>
        <translation>边：两种环绕方向的条带</translation>
    </message>
    <message>
        <source>edges one unit below centres</source>
        <translation>边：比中心低一个单位</translation>
    </message>
    <message>
        <source>edges one unit right of centres</source>
        <translation>边：比中心偏右一个单位</translation>
    </message>
    <message>
        <source>edges same face six orders</source>
        <translation>边：同一个面的六种顶点顺序</translation>
    </message>
    <message>
        <source>fan 5 hub on centre</source>
        <translation>扇形：5 片，轴心在像素中心</translation>
    </message>
    <message>
        <source>fan 12 hub on corner</source>
        <translation>扇形：12 片，轴心在像素角上</translation>
    </message>
    <message>
        <source>fan 32 mixed winding</source>
        <translation>扇形：32 片，环绕方向混合</translation>
    </message>
    <message>
        <source>fan 48 hub off centre</source>
        <translation>扇形：48 片，轴心偏离中心</translation>
    </message>
    <message>
        <source>fan 96 slivers</source>
        <translation>扇形：96 条细片</translation>
    </message>
    <message>
        <source>fan hub on left edge</source>
        <translation>扇形：轴心在左边界上</translation>
    </message>
    <message>
        <source>fan closed polygon</source>
        <translation>扇形：闭合多边形</translation>
    </message>
    <message>
        <source>sliver right of centre</source>
        <translation>细片：在中心右侧</translation>
    </message>
    <message>
        <source>sliver on centre</source>
        <translation>细片：正在中心上</translation>
    </message>
    <message>
        <source>sliver left of centre</source>
        <translation>细片：在中心左侧</translation>
    </message>
    <message>
        <source>sliver around centre</source>
        <translation>细片：跨过中心</translation>
    </message>
    <message>
        <source>sliver horizontal top</source>
        <translation>细片：水平，上边</translation>
    </message>
    <message>
        <source>sliver horizontal bottom</source>
        <translation>细片：水平，下边</translation>
    </message>
    <message>
        <source>sliver stack</source>
        <translation>细片：叠成一摞</translation>
    </message>
    <message>
        <source>sliver diagonal pair</source>
        <translation>细片：对角的一对</translation>
    </message>
    <message>
        <source>sliver two units at one end</source>
        <translation>细片：一端宽两个单位</translation>
    </message>
    <message>
        <source>needle 4096 window</source>
        <translation>细针：4096 像素的窗口</translation>
    </message>
    <message>
        <source>needle diagonal 16384</source>
        <translation>细针：16384 像素的对角线</translation>
    </message>
    <message>
        <source>needle tip on centre</source>
        <translation>细针：针尖在像素中心</translation>
    </message>
    <message>
        <source>needle star</source>
        <translation>细针：星形</translation>
    </message>
    <message>
        <source>huge four quadrants 1e9</source>
        <translation>极大：四个象限，1e9</translation>
    </message>
    <message>
        <source>huge four quadrants 1e20</source>
        <translation>极大：四个象限，1e20</translation>
    </message>
    <message>
        <source>huge four quadrants 3e38</source>
        <translation>极大：四个象限，3e38</translation>
    </message>
    <message>
        <source>huge half plane 1e9</source>
        <translation>极大：半平面，1e9</translation>
    </message>
    <message>
        <source>huge cover 3e38</source>
        <translation>极大：盖满画面，3e38</translation>
    </message>
    <message>
        <source>huge mixed scales</source>
        <translation>极大：大小混合</translation>
    </message>
    <message>
        <source>huge w</source>
        <translation>极大：w 很大</translation>
    </message>
    <message>
        <source>huge neighbours 1e6</source>
        <translation>极大：相邻的面，1e6</translation>
    </message>
    <message>
        <source>zero collinear through centres</source>
        <translation>零面积：共线，过像素中心</translation>
    </message>
    <message>
        <source>zero points</source>
        <translation>零面积：缩成点</translation>
    </message>
    <message>
        <source>zero after snapping small</source>
        <translation>零面积：对齐之后，小三角形</translation>
    </message>
    <message>
        <source>zero after snapping long</source>
        <translation>零面积：对齐之后，长三角形</translation>
    </message>
    <message>
        <source>zero after snapping exact</source>
        <translation>零面积：对齐之后，精确值</translation>
    </message>
    <message>
        <source>zero becomes area</source>
        <translation>零面积：变得有面积</translation>
    </message>
    <message>
        <source>zero huge line</source>
        <translation>零面积：极长的线</translation>
    </message>
    <message>
        <source>nan in each place</source>
        <translation>NaN：在每个位置</translation>
    </message>
    <message>
        <source>inf in each place</source>
        <translation>无穷大：在每个位置</translation>
    </message>
    <message>
        <source>nan everywhere</source>
        <translation>NaN：处处都是</translation>
    </message>
    <message>
        <source>inf w is not the origin</source>
        <translation>无穷大：w 无穷大不是原点</translation>
    </message>
    <message>
        <source>largest float</source>
        <translation>最大的浮点数</translation>
    </message>
    <message>
        <source>denormal smallest steps</source>
        <translation>非规格化数：最小的步长</translation>
    </message>
    <message>
        <source>denormal w only</source>
        <translation>非规格化数：只有 w</translation>
    </message>
    <message>
        <source>denormal offset</source>
        <translation>非规格化数：偏移</translation>
    </message>
    <message>
        <source>negative zero everywhere</source>
        <translation>负零：处处都是</translation>
    </message>
    <message>
        <source>negative zero w</source>
        <translation>负零：w</translation>
    </message>
    <message>
        <source>t junction on the edge</source>
        <translation>T 形接头：在边上</translation>
    </message>
    <message>
        <source>t junction crack</source>
        <translation>T 形接头：裂缝</translation>
    </message>
    <message>
        <source>t junction overlap</source>
        <translation>T 形接头：重叠</translation>
    </message>
    <message>
        <source>t junction repaired</source>
        <translation>T 形接头：已修补</translation>
    </message>
    <message>
        <source>on planes left and right</source>
        <translation>在平面上：左和右</translation>
    </message>
    <message>
        <source>on near plane all</source>
        <translation>在近平面上：全部</translation>
    </message>
    <message>
        <source>on far plane all</source>
        <translation>在远平面上：全部</translation>
    </message>
    <message>
        <source>on far plane lequal</source>
        <translation>在远平面上：小于或等于</translation>
    </message>
    <message>
        <source>on near plane one edge</source>
        <translation>在近平面上：一条边</translation>
    </message>
    <message>
        <source>on near plane one corner cut</source>
        <translation>在近平面上：一个角被裁掉</translation>
    </message>
    <message>
        <source>on volume corner</source>
        <translation>在视景体的角上</translation>
    </message>
    <message>
        <source>just outside left</source>
        <translation>刚好在左边之外</translation>
    </message>
    <message>
        <source>w zero one corner</source>
        <translation>w 为零：一个顶点</translation>
    </message>
    <message>
        <source>w zero two corners</source>
        <translation>w 为零：两个顶点</translation>
    </message>
    <message>
        <source>w zero all</source>
        <translation>w 为零：全部</translation>
    </message>
    <message>
        <source>w zero origin</source>
        <translation>w 为零：原点</translation>
    </message>
    <message>
        <source>w zero neighbours</source>
        <translation>w 为零：相邻的面</translation>
    </message>
    <message>
        <source>w negative one corner</source>
        <translation>w 为负：一个顶点</translation>
    </message>
    <message>
        <source>w negative two corners</source>
        <translation>w 为负：两个顶点</translation>
    </message>
    <message>
        <source>w negative all mirrored</source>
        <translation>w 为负：全部，镜像</translation>
    </message>
    <message>
        <source>w negative tiny</source>
        <translation>w 为负：极小</translation>
    </message>
    <message>
        <source>w negative culled</source>
        <translation>w 为负：被剔除</translation>
    </message>
    <message>
        <source>outside but covers</source>
        <translation>在外却盖住画面</translation>
    </message>
    <message>
        <source>outside passes the corner</source>
        <translation>在外：擦过一角</translation>
    </message>
    <message>
        <source>outside cuts the corner</source>
        <translation>在外：切过一角</translation>
    </message>
    <message>
        <source>outside six planes</source>
        <translation>在外：六个平面</translation>
    </message>
    <message>
        <source>eye in the plane</source>
        <translation>眼睛在面所在的平面上</translation>
    </message>
    <message>
        <source>eye in the plane behind too</source>
        <translation>眼睛在面所在的平面上，也有身后的部分</translation>
    </message>
    <message>
        <source>eye nearly in the plane</source>
        <translation>眼睛几乎在面所在的平面上</translation>
    </message>
    <message>
        <source>eye at small w</source>
        <translation>眼睛近处，w 很小</translation>
    </message>
    <message>
        <source>depth n0.1 f100 z50 float32</source>
        <translation>深度：n 0.1，f 100，z 50，float32</translation>
    </message>
    <message>
        <source>depth n0.1 f100 z50 unorm24</source>
        <translation>深度：n 0.1，f 100，z 50，unorm24</translation>
    </message>
    <message>
        <source>depth n0.1 f100 z50 unorm16</source>
        <translation>深度：n 0.1，f 100，z 50，unorm16</translation>
    </message>
    <message>
        <source>depth n0.1 f10000 z1000 float32</source>
        <translation>深度：n 0.1，f 10000，z 1000，float32</translation>
    </message>
    <message>
        <source>depth n0.1 f10000 z1000 unorm24</source>
        <translation>深度：n 0.1，f 10000，z 1000，unorm24</translation>
    </message>
    <message>
        <source>depth n0.1 f10000 z1000 unorm16</source>
        <translation>深度：n 0.1，f 10000，z 1000，unorm16</translation>
    </message>
    <message>
        <source>depth n1em05 f1e06 z1 float32</source>
        <translation>深度：n 1e-5，f 1e6，z 1，float32</translation>
    </message>
    <message>
        <source>depth n1em05 f1e06 z1 unorm24</source>
        <translation>深度：n 1e-5，f 1e6，z 1，unorm24</translation>
    </message>
    <message>
        <source>depth n1em05 f1e06 z1 unorm16</source>
        <translation>深度：n 1e-5，f 1e6，z 1，unorm16</translation>
    </message>
    <message>
        <source>depth reversed d3d float32</source>
        <translation>深度：反向 z，D3D，float32</translation>
    </message>
    <message>
        <source>depth reversed gl float32</source>
        <translation>深度：反向 z，OpenGL，float32</translation>
    </message>
    <message>
        <source>depth ratio 1e11</source>
        <translation>深度：远近比 1e11</translation>
    </message>
    <message>
        <source>depth ratio 1e11 reversed d3d</source>
        <translation>深度：远近比 1e11，反向 z，D3D</translation>
    </message>
    <message>
        <source>depth codes unorm16</source>
        <translation>深度：unorm16 的编码</translation>
    </message>
    <message>
        <source>depth codes unorm24</source>
        <translation>深度：unorm24 的编码</translation>
    </message>
    <message>
        <source>coplanar twice less</source>
        <translation>共面：画两次，小于</translation>
    </message>
    <message>
        <source>coplanar twice lequal</source>
        <translation>共面：画两次，小于或等于</translation>
    </message>
    <message>
        <source>coplanar other diagonal</source>
        <translation>共面：另一条对角线</translation>
    </message>
    <message>
        <source>coplanar decal</source>
        <translation>共面：贴花</translation>
    </message>
    <message>
        <source>piercing on centres</source>
        <translation>穿插：交线过像素中心</translation>
    </message>
    <message>
        <source>piercing cycle</source>
        <translation>穿插：成环</translation>
    </message>
    <message>
        <source>piercing perspective</source>
        <translation>穿插：透视</translation>
    </message>
    <message>
        <source>depth one ulp apart</source>
        <translation>深度：相差一个 ulp</translation>
    </message>
    <message>
        <source>depth denormal apart</source>
        <translation>深度：相差一个非规格化数</translation>
    </message>
    <message>
        <source>depth greater</source>
        <translation>深度：大于</translation>
    </message>
    <message>
        <source>depth none</source>
        <translation>深度：不测试</translation>
    </message>
    <message>
        <source>depth limits</source>
        <translation>深度：取值的两端</translation>
    </message>
    <message>
        <source>perspective ratio 10</source>
        <translation>透视：w 之比 10</translation>
    </message>
    <message>
        <source>perspective ratio 100</source>
        <translation>透视：w 之比 100</translation>
    </message>
    <message>
        <source>perspective ratio 1000</source>
        <translation>透视：w 之比 1000</translation>
    </message>
    <message>
        <source>perspective ratio 10000</source>
        <translation>透视：w 之比 10000</translation>
    </message>
    <message>
        <source>perspective constant</source>
        <translation>透视：常量</translation>
    </message>
    <message>
        <source>perspective three w</source>
        <translation>透视：三个不同的 w</translation>
    </message>
    <message>
        <source>perspective across w zero</source>
        <translation>透视：跨过 w = 0</translation>
    </message>
    <message>
        <source>perspective affine when flat</source>
        <translation>透视：平行于屏幕时就是仿射</translation>
    </message>
    <message>
        <source>cancellation one unit inside</source>
        <translation>相消：在内一个单位</translation>
    </message>
    <message>
        <source>cancellation one unit outside</source>
        <translation>相消：在外一个单位</translation>
    </message>
    <message>
        <source>cancellation on the edge</source>
        <translation>相消：恰在边上</translation>
    </message>
    <message>
        <source>cancellation big offset</source>
        <translation>相消：大偏移</translation>
    </message>
    <message>
        <source>drift edge 16384</source>
        <translation>漂移：边，16384 像素</translation>
    </message>
    <message>
        <source>drift steep 16384</source>
        <translation>漂移：陡边，16384 像素</translation>
    </message>
    <message>
        <source>drift colour 10000</source>
        <translation>漂移：颜色，10000 像素</translation>
    </message>
    <message>
        <source>drift depth 16384</source>
        <translation>漂移：深度，16384 像素</translation>
    </message>
    <message>
        <source>clip nine corners 1</source>
        <translation>裁剪：九个角，之一</translation>
    </message>
    <message>
        <source>clip nine corners 2</source>
        <translation>裁剪：九个角，之二</translation>
    </message>
    <message>
        <source>clip nine corners 3</source>
        <translation>裁剪：九个角，之三</translation>
    </message>
    <message>
        <source>clip nine corners d3d</source>
        <translation>裁剪：九个角，D3D</translation>
    </message>
    <message>
        <source>clip eight corners</source>
        <translation>裁剪：八个角</translation>
    </message>
    <message>
        <source>neighbours side planes</source>
        <translation>相邻的面：侧平面</translation>
    </message>
    <message>
        <source>neighbours side planes mixed winding</source>
        <translation>相邻的面：侧平面，环绕方向混合</translation>
    </message>
    <message>
        <source>neighbours far out</source>
        <translation>相邻的面：远在外面</translation>
    </message>
    <message>
        <source>neighbours near plane</source>
        <translation>相邻的面：近平面</translation>
    </message>
    <message>
        <source>neighbours far plane</source>
        <translation>相邻的面：远平面</translation>
    </message>
    <message>
        <source>neighbours ground through eye</source>
        <translation>相邻的面：穿过眼睛的地面</translation>
    </message>
    <message>
        <source>viewport 1x1</source>
        <translation>视口：1x1</translation>
    </message>
    <message>
        <source>viewport 1x16384</source>
        <translation>视口：1x16384</translation>
    </message>
    <message>
        <source>viewport 3x5</source>
        <translation>视口：3x5</translation>
    </message>
    <message>
        <source>viewport 2x2</source>
        <translation>视口：2x2</translation>
    </message>
    <message>
        <source>viewport 17x13</source>
        <translation>视口：17x13</translation>
    </message>
    <message>
        <source>viewport 255x1</source>
        <translation>视口：255x1</translation>
    </message>
    <message>
        <source>viewport 127x63</source>
        <translation>视口：127x63</translation>
    </message>
    <message>
        <source>viewport 1x257</source>
        <translation>视口：1x257</translation>
    </message>
    <message>
        <source>viewport 16384x2</source>
        <translation>视口：16384x2</translation>
    </message>
    <message>
        <source>cull front</source>
        <translation>剔除：正面</translation>
    </message>
    <message>
        <source>cull flipped by snapping</source>
        <translation>剔除：因对齐而翻转</translation>
    </message>
    <message>
        <source>cull none mesh</source>
        <translation>剔除：不剔除，网格</translation>
    </message>
    <message>
        <source>cull back mesh</source>
        <translation>剔除：背面，网格</translation>
    </message>
    <message>
        <source>snap bits 0</source>
        <translation>对齐：0 位</translation>
    </message>
    <message>
        <source>snap bits 1</source>
        <translation>对齐：1 位</translation>
    </message>
    <message>
        <source>snap bits 2</source>
        <translation>对齐：2 位</translation>
    </message>
    <message>
        <source>snap bits 3</source>
        <translation>对齐：3 位</translation>
    </message>
    <message>
        <source>snap bits 5</source>
        <translation>对齐：5 位</translation>
    </message>
    <message>
        <source>snap bits 0 mesh</source>
        <translation>对齐：0 位，网格</translation>
    </message>
    <message>
        <source>snap half to even</source>
        <translation>对齐：半数取偶</translation>
    </message>
    <message>
        <source>exact thirds</source>
        <translation>精确：三分之一</translation>
    </message>
    <message>
        <source>exact moves one pixel</source>
        <translation>精确：差一个像素</translation>
    </message>
    <message>
        <source>snapped moves one pixel</source>
        <translation>对齐：差一个像素</translation>
    </message>
    <message>
        <source>exact near cut</source>
        <translation>精确：近平面裁剪</translation>
    </message>
    <message>
        <source>samples 2x2</source>
        <translation>采样：2x2</translation>
    </message>
    <message>
        <source>samples 3x3</source>
        <translation>采样：3x3</translation>
    </message>
    <message>
        <source>samples 4x4</source>
        <translation>采样：4x4</translation>
    </message>
    <message>
        <source>samples 4x4 shared edge</source>
        <translation>采样：4x4，公共边</translation>
    </message>
    <message>
        <source>d3d near at zero</source>
        <translation>D3D：近平面在零</translation>
    </message>
    <message>
        <source>d3d behind near</source>
        <translation>D3D：在近平面后面</translation>
    </message>
    <message>
        <source>d3d cut at zero</source>
        <translation>D3D：在零处裁剪</translation>
    </message>
    <message>
        <source>clear colour</source>
        <translation>背景颜色</translation>
    </message>
    <message>
        <source>drift float32 missing</source>
        <translation>漂移：float32，缺失</translation>
    </message>
    <message>
        <source>drift float32 extra</source>
        <translation>漂移：float32，多余</translation>
    </message>
    <message>
        <source>snap folds cut face</source>
        <translation>对齐：被裁剪的面折叠</translation>
    </message>
    <message>
        <source>clip tie extra</source>
        <translation>裁剪：恰在边上，多余</translation>
    </message>
    <message>
        <source>clip tie missing</source>
        <translation>裁剪：恰在边上，缺失</translation>
    </message>
    <message>
        <source>clip tie behind eye</source>
        <translation>裁剪：恰在边上，眼睛后面</translation>
    </message>
    <message>
        <source>clip tie 1e7</source>
        <translation>裁剪：恰在边上，1e7</translation>
    </message>
    <message>
        <source>clip 1e8</source>
        <translation>裁剪：1e8</translation>
    </message>
    <message>
        <source>clip 1e10 d3d</source>
        <translation>裁剪：1e10，D3D</translation>
    </message>
    <message>
        <source>clip 1e15</source>
        <translation>裁剪：1e15</translation>
    </message>
    <message>
        <source>clip 1e15 fine grid</source>
        <translation>裁剪：1e15，细网格</translation>
    </message>
    <message>
        <source>clip 1e20 nothing</source>
        <translation>裁剪：1e20，什么也没剩下</translation>
    </message>
    <message>
        <source>clip 1e30</source>
        <translation>裁剪：1e30</translation>
    </message>
    <message>
        <source>clip largest</source>
        <translation>裁剪：最大值</translation>
    </message>
    <message>
        <source>clip largest quarter</source>
        <translation>裁剪：最大值，四分之一</translation>
    </message>
    <message>
        <source>clip largest neighbours</source>
        <translation>裁剪：最大值，相邻的面</translation>
    </message>
    <message>
        <source>edges quad falling diagonal</source>
        <translation>方形，下降的对角线</translation>
    </message>
    <message>
        <source>A square of 6 x 6 cut by its falling diagonal, one half wound the other way: 36 pixels, each once.</source>
        <translation>6 x 6 的方形被下降的对角线切开，一半绕向相反：36 个像素，每个一次。</translation>
    </message>
    <message>
        <source>The two faces run along the diagonal in one direction, so no sign is turned round between them.</source>
        <translation>两个面沿对角线走同一方向，所以它们之间没有符号相反。</translation>
    </message>
    <message>
        <source>edges quad rising diagonal</source>
        <translation>方形，上升的对角线</translation>
    </message>
    <message>
        <source>A square of 6 x 6 cut by its rising diagonal, one half wound the other way: 36 pixels, each once.</source>
        <translation>6 x 6 的方形被上升的对角线切开，一半绕向相反：36 个像素，每个一次。</translation>
    </message>
    <message>
        <source>cancellation small screen</source>
        <translation>小屏幕上的相消</translation>
    </message>
    <message>
        <source>A face wholly on a screen of 320 x 240: its edge values pass 32,767, yet no pixel is lost.</source>
        <translation>完全在 320 x 240 屏幕上的面：边函数值超过 32,767，却没有丢失像素。</translation>
    </message>
    <message>
        <source>The corners are those of a report on a driver that kept products in 16 bits.</source>
        <translation>这些角点来自一份报告：某驱动程序把乘积存成 16 位。</translation>
    </message>
    <message>
        <source>edges negative coordinates</source>
        <translation>负坐标</translation>
    </message>
    <message>
        <source>Corners at minus one half and beyond: a face that lies left of the screen is not seen in column 0.</source>
        <translation>角点在负二分之一及更左处：位于屏幕左边的面在第 0 列看不见。</translation>
    </message>
    <message>
        <source>Rounding towards zero would draw what lies at -0.5 at 0.</source>
        <translation>向零取整会把 -0.5 处的东西画到 0。</translation>
    </message>
    <message>
        <source>edges mirrored mesh</source>
        <translation>镜像的网格</translation>
    </message>
    <message>
        <source>A mesh with corners on pixel centres, and its mirror image: ties change their owner, every pixel is covered once.</source>
        <translation>角点在像素中心的网格及其镜像：恰在边上的中心换了归属，每个像素仍只覆盖一次。</translation>
    </message>
    <message>
        <source>edges moved by 8192</source>
        <translation>移动了 8192 的同一网格</translation>
    </message>
    <message>
        <source>The same four faces, and once more 8,192 pixels to the right: the same pixels of each.</source>
        <translation>同样的四个面，以及右移 8,192 像素的一份：各自的像素相同。</translation>
    </message>
    <message>
        <source>Distances to the corner of the screen decide nothing.</source>
        <translation>到屏幕角的距离不决定任何事。</translation>
    </message>
    <message>
        <source>clip at the guard band</source>
        <translation>恰在保护带边界</translation>
    </message>
    <message>
        <source>A corner exactly at the border of a guard band of 32,768 pixels, shared with a face that ends 1/256 of a pixel beyond.</source>
        <translation>一个角点恰在 32,768 像素保护带的边界上，与另一个多伸出 1/256 像素的面共用。</translation>
    </message>
    <message>
        <source>Neighbours of which one is cut and one is not share every pixel of their edge.</source>
        <translation>相邻两面一个被切、一个没有，公共边上的像素仍各归其一。</translation>
    </message>
    <message>
        <source>clip plane through a corner</source>
        <translation>裁剪平面穿过角点</translation>
    </message>
    <message>
        <source>The left border passes exactly through a corner: the cut there has length 0, and a neighbour shares it.</source>
        <translation>左边界恰好穿过一个角点：那里的切口长度为 0，且与邻面共用。</translation>
    </message>
    <message>
        <source>A corner on a plane is inside of it.</source>
        <translation>在平面上的角点算在内侧。</translation>
    </message>
    <message>
        <source>clip beside a corner</source>
        <translation>紧挨角点的切口</translation>
    </message>
    <message>
        <source>A corner 1/1024 of a pixel from the left border: the cut falls on the same step of the grid, and every pixel is covered once.</source>
        <translation>角点离左边界 1/1024 像素：切口落在同一网格步上，每个像素覆盖一次。</translation>
    </message>
    <message>
        <source>Four faces meet there and reach beyond the screen on all sides.</source>
        <translation>四个面在那里相会，四面都伸出屏幕。</translation>
    </message>
    <message>
        <source>clip corners on all planes</source>
        <translation>六个平面上都有角点</translation>
    </message>
    <message>
        <source>Corners on all six planes at once: every cut would be at an end of its edge, and nothing is lost.</source>
        <translation>六个平面上同时有角点：每个切口都在边的端点，什么也没丢。</translation>
    </message>
    <message>
        <source>The two faces run from the near plane on the left to the far plane on the right.</source>
        <translation>两个面从左边的近平面一直到右边的远平面。</translation>
    </message>
    <message>
        <source>clip keeps depth and colour</source>
        <translation>裁剪不改变深度和颜色</translation>
    </message>
    <message>
        <source>A face that the border cuts and one that it does not, in one plane: depth and colour follow the same plane in both.</source>
        <translation>同一平面上，一个面被边界切开，一个没有：两者的深度和颜色遵循同一平面。</translation>
    </message>
    <message>
        <source>Depth is 1/4 + (x + y) / 64 and red is 1/4 + x / 32.</source>
        <translation>深度为 1/4 + (x + y) / 64，红色为 1/4 + x / 32。</translation>
    </message>
    <message>
        <source>clip ground with corners behind</source>
        <translation>角点在身后的地面</translation>
    </message>
    <message>
        <source>A road from far on the right to behind the eye: x / w of all corners lies right of the screen, and the road is seen.</source>
        <translation>从右边远处到眼睛后面的路：所有角点的 x / w 都在屏幕右边，路却看得见。</translation>
    </message>
    <message>
        <source>A box of divided corners tells nothing where some w are negative.</source>
        <translation>有的 w 为负时，除过的角点的包围盒什么也说明不了。</translation>
    </message>
    <message>
        <source>texture border on centres</source>
        <translation>纹素边界在像素中心</translation>
    </message>
    <message>
        <source>Every pixel centre lies exactly on a border between texels: it shows the upper one.</source>
        <translation>每个像素中心恰在纹素的边界上：显示上面的那个。</translation>
    </message>
    <message>
        <source>A texel begins at its lower border; u W is a whole number at every centre, 1 at the first.</source>
        <translation>纹素从它的下边界开始；每个中心处 u W 都是整数，第一个为 1。</translation>
    </message>
    <message>
        <source>texture u is one</source>
        <translation>u 恰为 1</translation>
    </message>
    <message>
        <source>At the last column u is exactly 1, which is the first texel of the next repeat.</source>
        <translation>最后一列 u 恰为 1，即下一次重复的第一个纹素。</translation>
    </message>
    <message>
        <source>A clamped coordinate would show the last texel once more.</source>
        <translation>若坐标被截断，会再显示一次最后的纹素。</translation>
    </message>
    <message>
        <source>texture negative</source>
        <translation>负的纹理坐标</translation>
    </message>
    <message>
        <source>u and v run from -2 to 0: the texels left of 0 are as wide as those right of it.</source>
        <translation>u 和 v 从 -2 到 0：0 左边的纹素和右边的一样宽。</translation>
    </message>
    <message>
        <source>texture about zero on centres</source>
        <translation>0 附近，边界在中心</translation>
    </message>
    <message>
        <source>u W is a whole number at every centre, below 0 on the left half and above it on the right.</source>
        <translation>每个中心处 u W 都是整数，左半边小于 0，右半边大于 0。</translation>
    </message>
    <message>
        <source>texture mirrored on centres</source>
        <translation>镜像，边界在中心</translation>
    </message>
    <message>
        <source>u runs from right to left, and every centre lies on a border: it still shows the upper texel.</source>
        <translation>u 从右往左走，每个中心都在边界上：显示的仍是上面的纹素。</translation>
    </message>
    <message>
        <source>texture beyond 2 24</source>
        <translation>超过 2^24 的纹理坐标</translation>
    </message>
    <message>
        <source>u is 2^24 at all corners, and 2^25 at those of the other half: whole numbers are the first texel however large.</source>
        <translation>所有角点的 u 为 2^24，另一半为 2^25：整数不论多大都是第一个纹素。</translation>
    </message>
    <message>
        <source>Of a float32 that large no part is left behind the point.</source>
        <translation>这么大的 float32 小数点后什么也不剩。</translation>
    </message>
    <message>
        <source>texture no derivative</source>
        <translation>没有导数</translation>
    </message>
    <message>
        <source>All three corners have one place in the texture: there is no derivative, and no level but the first.</source>
        <translation>三个角在纹理中是同一处：没有导数，也没有第一级以外的级别。</translation>
    </message>
    <message>
        <source>texture turned on borders</source>
        <translation>转了 45 度的纹理</translation>
    </message>
    <message>
        <source>A texture turned by 45 degrees: along every second diagonal the centres lie on borders of both axes.</source>
        <translation>转了 45 度的纹理：每隔一条对角线，中心落在两个轴的边界上。</translation>
    </message>
    <message>
        <source>texture perspective 8</source>
        <translation>透视比 8 的纹理</translation>
    </message>
    <message>
        <source>A square in perspective, w from 1 to 8: every nearest texel is the one that exact numbers give.</source>
        <translation>透视中的方形，w 从 1 到 8：每个最近的纹素都是精确数给出的那个。</translation>
    </message>
    <message>
        <source>One face has the far corners, so the texture is denser along its upper edge.</source>
        <translation>一个面有远处的角，所以纹理沿上边更密。</translation>
    </message>
    <message>
        <source>texture three texels a sample</source>
        <translation>每个采样三个纹素</translation>
    </message>
    <message>
        <source>Three texels a sample and a texture of three: every sample shows the same texel.</source>
        <translation>每个采样三个纹素，而纹理正好三个：每个采样显示同一个纹素。</translation>
    </message>
    <message>
        <source>The middle texel of each repeat lies under the centre.</source>
        <translation>每次重复的中间那个纹素在中心之下。</translation>
    </message>
    <message>
        <source>corner orders equal depth</source>
        <translation>顶点次序与相等深度</translation>
    </message>
    <message>
        <source>The same face in the other five corner orders, drawn where depths are equal: every pixel passes each time.</source>
        <translation>同一个面以另外五种顶点次序再画，只画在深度相等处：每次所有像素都通过。</translation>
    </message>
    <message>
        <source>llvmpipe loses 42 % of the pixels of such a pass, SwiftShader 14 %.</source>
        <translation>这样的一遍，llvmpipe 丢失 42 % 的像素，SwiftShader 丢失 14 %。</translation>
    </message>
    <message>
        <source>constant depth float32</source>
        <translation>恒定深度 float32</translation>
    </message>
    <message>
        <source>One depth everywhere, whatever x, y and w of the corners: a second pass where depths are equal covers all of the first.</source>
        <translation>无论顶点的 x、y、w 如何，深度处处相同：只画在深度相等处的第二遍盖住整个第一遍。</translation>
    </message>
    <message>
        <source>constant depth unorm24</source>
        <translation>恒定深度 unorm24</translation>
    </message>
    <message>
        <source>constant depth unorm16</source>
        <translation>恒定深度 unorm16</translation>
    </message>
    <message>
        <source>equal other tessellation</source>
        <translation>相等深度，另一种剖分</translation>
    </message>
    <message>
        <source>A plane cut by its other diagonal in a second pass, where depths are equal: every pixel passes.</source>
        <translation>第二遍沿另一条对角线剖分同一平面，只画在深度相等处：所有像素都通过。</translation>
    </message>
    <message>
        <source>slope ten thousand</source>
        <translation>坡度一万</translation>
    </message>
    <message>
        <source>Depth rises by more than 10,000 a pixel across a needle: on its edge it is that of the edge.</source>
        <translation>横穿细针形三角形时，深度每像素升高一万以上：在边上，它就是边的深度。</translation>
    </message>
    <message>
        <source>bias constant unorm16</source>
        <translation>常数偏移 unorm16</translation>
    </message>
    <message>
        <source>A bias of minus one unit brings a second pass one code nearer: it wins everywhere.</source>
        <translation>负一个单位的偏移让第二遍近一个编码：它处处胜出。</translation>
    </message>
    <message>
        <source>bias float32 exponent</source>
        <translation>float32 偏移随指数变化</translation>
    </message>
    <message>
        <source>The unit of float32 follows the exponent of the deepest corner: at 0.3 it is 2^-25, at 0.75 it is 2^-24.</source>
        <translation>float32 的单位取决于最深顶点的指数：0.3 处是 2^-25，0.75 处是 2^-24。</translation>
    </message>
    <message>
        <source>bias slope</source>
        <translation>坡度偏移</translation>
    </message>
    <message>
        <source>A bias of two slopes moves a face by what depth changes on two pixels.</source>
        <translation>两倍坡度的偏移，使面移动两个像素上的深度变化量。</translation>
    </message>
    <message>
        <source>bias clamped</source>
        <translation>偏移有上限</translation>
    </message>
    <message>
        <source>The same bias of two slopes, held at 0.01.</source>
        <translation>同样两倍坡度的偏移，限制在 0.01。</translation>
    </message>
    <message>
        <source>bias clamped below</source>
        <translation>偏移有下限</translation>
    </message>
    <message>
        <source>A negative clamp holds a negative bias, and no positive one.</source>
        <translation>负的限制只限制负的偏移，不限制正的。</translation>
    </message>
    <message>
        <source>depth range middle</source>
        <translation>深度范围在中间</translation>
    </message>
    <message>
        <source>Near is mapped to 0.25 and far to 0.75.</source>
        <translation>近平面映射到 0.25，远平面映射到 0.75。</translation>
    </message>
    <message>
        <source>depth range reversed</source>
        <translation>深度范围颠倒</translation>
    </message>
    <message>
        <source>Near is mapped to 0.75 and far to 0.25: the greater depth is the nearer one.</source>
        <translation>近平面映射到 0.75，远平面映射到 0.25：深度大的更近。</translation>
    </message>
    <message>
        <source>depth range empty</source>
        <translation>深度范围为空</translation>
    </message>
    <message>
        <source>Near and far are both mapped to 0.5: all depths are equal, and the first face stays.</source>
        <translation>近、远平面都映射到 0.5：所有深度相等，先画的面留下。</translation>
    </message>
    <message>
        <source>depth clear not representable</source>
        <translation>清除值无法精确表示</translation>
    </message>
    <message>
        <source>The buffer is cleared to 0.35, which 16 bits do not hold: a face at 0.35 is equal all the same.</source>
        <translation>缓冲清除为 0.35，16 位存不下这个数：深度 0.35 的面仍然相等。</translation>
    </message>
    <message>
        <source>depth clamp before near</source>
        <translation>近平面之前钳制深度</translation>
    </message>
    <message>
        <source>Half of the face lies before the near plane: it is drawn there at depth 0.</source>
        <translation>面的一半在近平面之前：那里以深度 0 画出。</translation>
    </message>
    <message>
        <source>depth clamp beyond far</source>
        <translation>远平面之后钳制深度</translation>
    </message>
    <message>
        <source>Half of the face lies beyond the far plane: it is drawn there at depth 1.</source>
        <translation>面的一半在远平面之后：那里以深度 1 画出。</translation>
    </message>
    <message>
        <source>A vertical edge runs exactly through the first of two samples of a column: the face on its right has it.</source>
        <translation>一条竖直边正好穿过一列像素两个采样中的第一个：归它右边的面。</translation>
    </message>
    <message>
        <source>Samples lie a quarter of a pixel right and below the centre, and left and above it (Direct3D, Vulkan).</source>
        <translation>两个采样分别在中心右下和左上各四分之一像素处（Direct3D、Vulkan）。</translation>
    </message>
    <message>
        <source>A horizontal edge runs exactly through the first of four samples of a row: the face below it has it.</source>
        <translation>一条水平边正好穿过一行像素四个采样中的第一个：归它下方的面。</translation>
    </message>
    <message>
        <source>The first sample lies 2/16 left and 6/16 above the centre.</source>
        <translation>第一个采样在中心左 2/16、上 6/16 像素处。</translation>
    </message>
    <message>
        <source>A slanted edge runs exactly through the first of eight samples of eight pixels: the face on its right has them.</source>
        <translation>一条斜边正好穿过八个像素各自八个采样中的第一个：都归它右边的面。</translation>
    </message>
    <message>
        <source>The first sample lies 1/16 right and 3/16 above the centre, and the edge where x - y is 1/4.</source>
        <translation>第一个采样在中心右 1/16、上 3/16 像素处，边在 x - y = 1/4 处。</translation>
    </message>
    <message>
        <source>The diagonal runs exactly through the first of sixteen samples of eight pixels: the face on its right has them.</source>
        <translation>对角线正好穿过八个像素各自十六个采样中的第一个：都归它右边的面。</translation>
    </message>
    <message>
        <source>The first sample lies 1/16 right and 1/16 below the centre.</source>
        <translation>第一个采样在中心右 1/16、下 1/16 像素处。</translation>
    </message>
    <message>
        <source>Two faces of one colour share a slanted edge under four samples a pixel: no seam in the colour.</source>
        <translation>每像素四个采样，两个同色面共用一条斜边：颜色上没有接缝。</translation>
    </message>
    <message>
        <source>Each sample belongs to one of them: their masks complement each other.</source>
        <translation>每个采样只归其中一个面：两者的掩码互补。</translation>
    </message>
    <message>
        <source>A face covers one of four samples and not the centre: attributes are taken at that sample.</source>
        <translation>面只覆盖四个采样中的一个而不含中心：属性取自该采样处。</translation>
    </message>
    <message>
        <source>Red falls from 1 to 0 within half a pixel. The sample at x = 3.875 has 3/4, the centre outside would have 3/2.</source>
        <translation>红色在半个像素内由 1 降到 0。x = 3.875 处的采样为 3/4，面外的中心则会得 3/2。</translation>
    </message>
    <message>
        <source>The pixel shows a quarter of 191, for the other three samples are black.</source>
        <translation>像素显示 191 的四分之一，因为其余三个采样是黑色。</translation>
    </message>
    <message>
        <source>Conservative: the triangle has every pixel whose square it touches, with a corner at least: 15.</source>
        <translation>保守：方格哪怕只有一角被触及的像素都归三角形：15 个。</translation>
    </message>
    <message>
        <source>Inner: the triangle has the pixels whose whole square it holds: 6.</source>
        <translation>内保守：只有整个方格都在三角形内的像素才归它：6 个。</translation>
    </message>
    <message>
        <source>Its slanted edge runs through corners of pixels, where x + y is 4.</source>
        <translation>它的斜边在 x + y = 4 处穿过像素的角点。</translation>
    </message>
    <message>
        <source>Conservative: a sliver that has no centre has the five pixels of its row that it reaches.</source>
        <translation>保守：不含任何中心的细长三角形得到它在这一行触及的五个像素。</translation>
    </message>
    <message>
        <source>Conservative: two faces that share an edge both have the pixels that it runs through.</source>
        <translation>保守：共用一条边的两个面都得到该边穿过的像素。</translation>
    </message>
    <message>
        <source>The edge x = 3.5 runs through column 3: its 8 pixels are hit twice, and no tie rule is asked.</source>
        <translation>边 x = 3.5 穿过第 3 列：这 8 个像素都被命中两次，不问边界归属规则。</translation>
    </message>
    <message>
        <source>samples edge on msaa2</source>
        <translation>采样恰在边上，msaa2</translation>
    </message>
    <message>
        <source>samples edge on msaa4</source>
        <translation>采样恰在边上，msaa4</translation>
    </message>
    <message>
        <source>samples edge on msaa8</source>
        <translation>采样恰在边上，msaa8</translation>
    </message>
    <message>
        <source>samples edge on msaa16</source>
        <translation>采样恰在边上，msaa16</translation>
    </message>
    <message>
        <source>samples shared edge msaa4</source>
        <translation>共用边，msaa4</translation>
    </message>
    <message>
        <source>samples centroid</source>
        <translation>质心采样</translation>
    </message>
    <message>
        <source>coverage conservative</source>
        <translation>覆盖：保守</translation>
    </message>
    <message>
        <source>coverage inner</source>
        <translation>覆盖：内保守</translation>
    </message>
    <message>
        <source>coverage conservative sliver</source>
        <translation>覆盖：保守，细长三角形</translation>
    </message>
    <message>
        <source>coverage conservative shared edge</source>
        <translation>覆盖：保守，共用边</translation>
    </message>
    <message>
        <source>line ends in diamonds</source>
        <translation>线端在菱形中</translation>
    </message>
    <message>
        <source>line strip diamond exit</source>
        <translation>折线，菱形离开规则</translation>
    </message>
    <message>
        <source>line strip half open</source>
        <translation>折线，半开规则</translation>
    </message>
    <message>
        <source>line there and back</source>
        <translation>线的往返</translation>
    </message>
    <message>
        <source>line there and back canonical</source>
        <translation>线的往返，两个方向相同</translation>
    </message>
    <message>
        <source>line perspective and near</source>
        <translation>线，透视与近平面</translation>
    </message>
    <message>
        <source>line before and behind a face</source>
        <translation>线在面的前后</translation>
    </message>
    <message>
        <source>line within one pixel</source>
        <translation>一个像素内的线</translation>
    </message>
    <message>
        <source>Where in its diamond a line starts or ends decides whether it has that pixel.</source>
        <translation>线在菱形中的何处开始或结束，决定它是否占有那个像素。</translation>
    </message>
    <message>
        <source>The ends of a report on MoltenVK (1123), a row each, and two on a centre and on a border.</source>
        <translation>端点取自 MoltenVK 的一份报告（1123），每行一条；另外两条的端点在像素中心和边界上。</translation>
    </message>
    <message>
        <source>A strip of six lines: every pixel once, also where two lines meet.</source>
        <translation>六条线组成的折线：每个像素只画一次，两条线相接处也是。</translation>
    </message>
    <message>
        <source>Ends lie on centres and beside them; a line that ends within a diamond leaves it to the next one.</source>
        <translation>端点在像素中心或旁边；在菱形内结束的线把这个像素留给下一条线。</translation>
    </message>
    <message>
        <source>A strip of six lines without their last pixels: every pixel once, also where two lines meet.</source>
        <translation>六条线组成的折线，都不画最后一个像素：每个像素只画一次，两条线相接处也是。</translation>
    </message>
    <message>
        <source>Each line leaves out the pixel in which the next one starts.</source>
        <translation>每条线都不画下一条线开始的那个像素。</translation>
    </message>
    <message>
        <source>A line from A to B and one from B to A: where it passes half-way between two pixels, each takes its own.</source>
        <translation>一条线从 A 到 B，一条从 B 到 A：恰好经过两个像素正中时，两条线各取各的像素。</translation>
    </message>
    <message>
        <source>Slopes of 1/2, 3, 1 and 1/9: of these only the first passes half-way.</source>
        <translation>斜率为 1/2、3、1 和 1/9：其中只有第一条会经过正中。</translation>
    </message>
    <message>
        <source>A line from A to B and one from B to A: with one choice for both directions they have the same pixels.</source>
        <translation>一条线从 A 到 B，一条从 B 到 A：两个方向取法相同时，它们的像素也相同。</translation>
    </message>
    <message>
        <source>The line that goes up is drawn as the one that goes down.</source>
        <translation>向上的线按向下的线来画。</translation>
    </message>
    <message>
        <source>Lines in perspective, one with its end behind the eye: cut like the edge of a face.</source>
        <translation>透视下的线，其中一条的端点在眼睛后面：像面的边一样裁剪。</translation>
    </message>
    <message>
        <source>Colour is perspective-correct, depth linear on the screen.</source>
        <translation>颜色经过透视校正，深度在屏幕上是线性的。</translation>
    </message>
    <message>
        <source>Lines before, in and behind a face: the depth test parts them, and a depth bias moves none.</source>
        <translation>线在面的前面、面内和后面：深度测试把它们分开，深度偏移不移动任何一条线。</translation>
    </message>
    <message>
        <source>The bias lifts the face, and no line: the red one, as deep as the face, is hidden by it.</source>
        <translation>偏移抬高的是面，不是线：与面同深的红线被面遮住。</translation>
    </message>
    <message>
        <source>Lines within one pixel have it, and a line beside the picture has none.</source>
        <translation>一个像素内的线占有这个像素，画面外的线什么也没有。</translation>
    </message>
    <message>
        <source>Under half-open and diamond-exit they have none.</source>
        <translation>按半开规则和菱形离开规则，它们一个像素也没有。</translation>
    </message>
</context>
<context>
    <name>ImageExport</name>
    <message>
        <source>%1 could not be written: %2</source>
        <translation>无法写入 %1：%2</translation>
    </message>
</context>
<context>
    <name>LatestResult</name>
    <message>
        <source>there is not enough memory</source>
        <translation>内存不足</translation>
    </message>
    <message>
        <source>the system does not start so many threads</source>
        <translation>系统无法启动这么多线程</translation>
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
        <translation>恰在边上</translation>
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
        <translation>恰在边上：%1，%2</translation>
    </message>
    <message>
        <source>no edge: the list of y is empty</source>
        <translation>没有边：y 的列表为空</translation>
    </message>
    <message>
        <source>pixel (%1, %2): %3 samples and their mean</source>
        <translation>像素 (%1, %2)：%3 个采样点和它们的平均</translation>
    </message>
    <message>
        <source>pixel (%1, %2): what its samples store now</source>
        <translation>像素 (%1, %2)：各采样点现在存的值</translation>
    </message>
    <message>
        <source>upper half</source>
        <translation>上半部分</translation>
    </message>
    <message>
        <source>lower half</source>
        <translation>下半部分</translation>
    </message>
    <message>
        <source>upper half: short edge %1</source>
        <translation>上半部分：短边 %1</translation>
    </message>
    <message>
        <source>lower half: short edge %1</source>
        <translation>下半部分：短边 %1</translation>
    </message>
    <message>
        <source>long edge 1-3: %1</source>
        <translation>长边 1-3：%1</translation>
    </message>
    <message>
        <source>broken edge 1-2-3: %1, %2</source>
        <translation>折边 1-2-3：%1、%2</translation>
    </message>
    <message>
        <source>inside this edge</source>
        <translation>在这条边内侧</translation>
    </message>
    <message>
        <source>outside it</source>
        <translation>在外侧</translation>
    </message>
    <message>
        <source>exactly on it</source>
        <translation>恰在边上</translation>
    </message>
    <message>
        <source>number: E, px²</source>
        <translation>数字：E，px²</translation>
    </message>
    <message>
        <source>shaded at each of them</source>
        <translation>在其中每一个上着色</translation>
    </message>
    <message>
        <source>shaded once, at sample %1, the first covered one</source>
        <translation>着色一次，在采样点 %1，即第一个被覆盖的采样点</translation>
    </message>
    <message>
        <source>shaded once, at the centre</source>
        <translation>着色一次，在像素中心</translation>
    </message>
    <message>
        <source>shaded once, at the centre, outside of the face: %1</source>
        <translation>着色一次，在像素中心，而中心在面之外：%1</translation>
    </message>
    <message>
        <source>pixel (%1, %2): </source>
        <translation>像素 (%1, %2)：</translation>
    </message>
    <message>
        <source>none of %1 samples is covered</source>
        <translation>%1 个采样点都没有被覆盖</translation>
    </message>
    <message>
        <source>%1 of %2 samples are covered: %3</source>
        <translation>%2 个采样点中有 %1 个被覆盖：%3</translation>
    </message>
    <message>
        <source>%1 enters the diamond at %2</source>
        <translation>%1 在 %2 进入菱形</translation>
    </message>
    <message>
        <source>%1 starts in the diamond</source>
        <translation>%1 起于菱形内</translation>
    </message>
    <message>
        <source>leaves it at %1</source>
        <translation>在 %1 离开</translation>
    </message>
    <message>
        <source>ends at its border or within</source>
        <translation>止于其边界或其内</translation>
    </message>
    <message>
        <source>drawn</source>
        <translation>画</translation>
    </message>
    <message>
        <source>not drawn</source>
        <translation>不画</translation>
    </message>
    <message>
        <source>sample, covered</source>
        <translation>被覆盖的点</translation>
    </message>
    <message>
        <source>not covered</source>
        <translation>未覆盖的点</translation>
    </message>
    <message>
        <source>shaded here</source>
        <translation>在此着色</translation>
    </message>
    <message>
        <source>shaded outside</source>
        <translation>在面外着色</translation>
    </message>
</context>
<context>
    <name>LocateModel</name>
    <message>
        <source>Locate the model of %1</source>
        <translation>查找 %1 的模型</translation>
    </message>
    <message>
        <source>Scenes and cases (*.obj *.case)</source>
        <translation>场景和用例 (*.obj *.case)</translation>
    </message>
    <message>
        <source>The model of this session is not where it was.</source>
        <translation>这个会话的模型已不在原处。</translation>
    </message>
    <message>
        <source>Locate…</source>
        <translation>查找…</translation>
    </message>
</context>
<context>
    <name>Mistake</name>
    <message>
        <source>All edges are inclusive</source>
        <translation>所有边都算在内</translation>
    </message>
    <message>
        <source>Pixels on a shared edge are drawn by both triangles: wrong where colours blend or are counted.</source>
        <translation>公共边上的像素被两个三角形各画一次：混合颜色或计数时就会出错。</translation>
    </message>
    <message>
        <source>inside = E_AB &gt;= 0 &amp;&amp; E_BC &gt;= 0 &amp;&amp; E_CA &gt;= 0</source>
        <translation>inside = E_AB &gt;= 0 &amp;&amp; E_BC &gt;= 0 &amp;&amp; E_CA &gt;= 0</translation>
    </message>
    <message>
        <source>A point on the edge is in the triangle, is it not?</source>
        <translation>边上的点难道不属于三角形吗？</translation>
    </message>
    <message>
        <source>All edges are exclusive</source>
        <translation>所有边都不算在内</translation>
    </message>
    <message>
        <source>Pixels on a shared edge are drawn by neither triangle: a row of holes.</source>
        <translation>公共边上的像素两个三角形都不画：留下一排洞。</translation>
    </message>
    <message>
        <source>inside = E_AB &gt; 0 &amp;&amp; E_BC &gt; 0 &amp;&amp; E_CA &gt; 0</source>
        <translation>inside = E_AB &gt; 0 &amp;&amp; E_BC &gt; 0 &amp;&amp; E_CA &gt; 0</translation>
    </message>
    <message>
        <source>It stops pixels from being drawn twice.</source>
        <translation>这样像素就不会被画两次。</translation>
    </message>
    <message>
        <source>Top-left bias with &quot;all positive or all negative&quot;</source>
        <translation>左上规则偏移加上“全正或全负”</translation>
    </message>
    <message>
        <source>Counter-clockwise triangles are right, at the shared edges of clockwise ones pixels are drawn twice.</source>
        <translation>逆时针三角形正确，顺时针三角形的公共边上像素被画两次。</translation>
    </message>
    <message>
        <source>inside = all E + bias &gt;= 0 || all E + bias &lt;= 0</source>
        <translation>inside = all E + bias &gt;= 0 || all E + bias &lt;= 0</translation>
    </message>
    <message>
        <source>It makes the test independent of the winding; the bias is not.</source>
        <translation>这样测试与环绕方向无关，但偏移并非如此。</translation>
    </message>
    <message>
        <source>A fixed bias of 1 on floating-point edges</source>
        <translation>浮点边函数上固定偏移 1</translation>
    </message>
    <message>
        <source>A crack between neighbours, the wider the shorter the edge; small triangles vanish.</source>
        <translation>相邻三角形之间出现裂缝，边越短裂缝越宽；小三角形消失。</translation>
    </message>
    <message>
        <source>float bias = ownsPoints ? 0 : -1</source>
        <translation>float bias = ownsPoints ? 0 : -1</translation>
    </message>
    <message>
        <source>In integers, 1 is the smallest step. In floats it is a pixel.</source>
        <translation>整数里 1 是最小的一步；浮点里它是一整个像素。</translation>
    </message>
    <message>
        <source>Sampled at the pixel&apos;s corner</source>
        <translation>在像素角上采样</translation>
    </message>
    <message>
        <source>The picture sits half a pixel too far right and down.</source>
        <translation>画面向右下偏移半个像素。</translation>
    </message>
    <message>
        <source>E_AB(x, y) in place of E_AB(x + 0.5, y + 0.5)</source>
        <translation>E_AB(x, y) in place of E_AB(x + 0.5, y + 0.5)</translation>
    </message>
    <message>
        <source>The loop variables are right there.</source>
        <translation>循环变量就在手边。</translation>
    </message>
    <message>
        <source>Vertices are cast to int</source>
        <translation>顶点被转换为 int</translation>
    </message>
    <message>
        <source>Edges jump by whole pixels when something moves, and triangles smaller than a pixel collapse.</source>
        <translation>物体移动时边按整像素跳动，小于一个像素的三角形塌缩。</translation>
    </message>
    <message>
        <source>Vec2i p = {(int)v.x, (int)v.y}</source>
        <translation>Vec2i p = {(int)v.x, (int)v.y}</translation>
    </message>
    <message>
        <source>Pixels have integer coordinates.</source>
        <translation>像素的坐标是整数。</translation>
    </message>
    <message>
        <source>One winding only, and triangles are not oriented</source>
        <translation>只处理一种环绕方向，且不调整三角形</translation>
    </message>
    <message>
        <source>Clockwise triangles vanish although nothing is culled.</source>
        <translation>没有剔除，顺时针三角形却消失了。</translation>
    </message>
    <message>
        <source>area is not looked at before the edges are set up</source>
        <translation>area is not looked at before the edges are set up</translation>
    </message>
    <message>
        <source>The first triangle one tries works.</source>
        <translation>试的第一个三角形是对的。</translation>
    </message>
    <message>
        <source>Barycentric weights rotated by one corner</source>
        <translation>重心坐标权重错位一个顶点</translation>
    </message>
    <message>
        <source>All colours move on by one corner.</source>
        <translation>所有颜色都挪到下一个顶点。</translation>
    </message>
    <message>
        <source>α = E_AB / area in place of E_BC / area</source>
        <translation>α = E_AB / area in place of E_BC / area</translation>
    </message>
    <message>
        <source>The edge is named after its first corner; its value belongs to the corner opposite.</source>
        <translation>边以它的第一个顶点命名，而它的值属于对面的顶点。</translation>
    </message>
    <message>
        <source>Two barycentric weights exchanged</source>
        <translation>两个重心坐标权重互换</translation>
    </message>
    <message>
        <source>Two corners have each other&apos;s colour.</source>
        <translation>两个顶点的颜色互换了。</translation>
    </message>
    <message>
        <source>color = α * A + γ * B + β * C</source>
        <translation>color = α * A + γ * B + β * C</translation>
    </message>
    <message>
        <source>B and C were swapped to turn the triangle round, and only they.</source>
        <translation>为了翻转三角形交换了 B 和 C，却只交换了它们。</translation>
    </message>
    <message>
        <source>The interpolated position overwrites the pixel&apos;s</source>
        <translation>插值得到的位置覆盖了像素位置</translation>
    </message>
    <message>
        <source>Holes like pepper: 6.9999995 is cut to 6, and its neighbour is drawn twice.</source>
        <translation>像胡椒一样的小洞：6.9999995 被截成 6，旁边的像素画了两次。</translation>
    </message>
    <message>
        <source>x = (int)(α * A.x + β * B.x + γ * C.x)</source>
        <translation>x = (int)(α * A.x + β * B.x + γ * C.x)</translation>
    </message>
    <message>
        <source>Position is an attribute like all others.</source>
        <translation>位置和其他属性没有区别。</translation>
    </message>
    <message>
        <source>Sorting by y moves positions only</source>
        <translation>按 y 排序时只移动了位置</translation>
    </message>
    <message>
        <source>Colours sit at wrong corners, in some triangles and not in others.</source>
        <translation>颜色落在错误的顶点上，有的三角形错，有的不错。</translation>
    </message>
    <message>
        <source>if (b.y &lt; a.y) swap(a.position, b.position)</source>
        <translation>if (b.y &lt; a.y) swap(a.position, b.position)</translation>
    </message>
    <message>
        <source>The sort was there before the colours were.</source>
        <translation>先有排序，后有颜色。</translation>
    </message>
    <message>
        <source>+1 on the height of an edge</source>
        <translation>边的高度加 1</translation>
    </message>
    <message>
        <source>alpha = (y - a.y) / (b.y - a.y + 1)</source>
        <translation>alpha = (y - a.y) / (b.y - a.y + 1)</translation>
    </message>
    <message>
        <source>It avoids dividing by zero.</source>
        <translation>这样避免了除以零。</translation>
    </message>
    <message>
        <source>Steep lines column by column</source>
        <translation>陡线逐列绘制</translation>
    </message>
    <message>
        <source>A line of 1 x 10 ends at y = 20; of vertical lines, which would divide by zero, only a dot is left.</source>
        <translation>1 × 10 的线画到了 y = 20；竖线会除以零，只剩一个点。</translation>
    </message>
    <message>
        <source>error += dy / dx; while (error &gt; 0.5) ++y</source>
        <translation>error += dy / dx; while (error &gt; 0.5) ++y</translation>
    </message>
    <message>
        <source>It looks like the line algorithm, for flat lines.</source>
        <translation>对平缓的线，它看起来就是画线算法。</translation>
    </message>
    <message>
        <source>Steep lines with one pixel a column</source>
        <translation>陡线每列只画一个像素</translation>
    </message>
    <message>
        <source>Steep lines are dots that lie far apart, and jump two columns&apos; way at once: 6, 0, 6, 0 rows for 3, 3, 3, 3.</source>
        <translation>陡线变成相距很远的点，而且一次跳两列的行数：本应每列 3、3、3、3 行，却成了 6、0、6、0。</translation>
    </message>
    <message>
        <source>step = error / dx; y += step; error -= 2 * dx * step</source>
        <translation>step = error / dx; y += step; error -= 2 * dx * step</translation>
    </message>
    <message>
        <source>It was made for filling columns, which needs one y of each edge in a column.</source>
        <translation>它原本用于逐列填充：那里每条边在一列中只需要一个 y。</translation>
    </message>
    <message>
        <source>The weight along a line divided in integers</source>
        <translation>沿线的权重用整数除法</translation>
    </message>
    <message>
        <source>Each line has one colour from its first pixel to the last but one.</source>
        <translation>每条线从第一个像素到倒数第二个像素都是同一种颜色。</translation>
    </message>
    <message>
        <source>float t = i / n, both int</source>
        <translation>float t = i / n, both int</translation>
    </message>
    <message>
        <source>The result is stored in a float.</source>
        <translation>结果存放在 float 里。</translation>
    </message>
    <message>
        <source>An octant of the line algorithm is missing</source>
        <translation>画线算法漏了一个八分区</translation>
    </message>
    <message>
        <source>Lines in one direction are not drawn.</source>
        <translation>某个方向的线不画。</translation>
    </message>
    <message>
        <source>if (dy &gt; dx &amp;&amp; dx &gt; 0 &amp;&amp; dy &gt; 0) is never written</source>
        <translation>if (dy &gt; dx &amp;&amp; dx &gt; 0 &amp;&amp; dy &gt; 0) is never written</translation>
    </message>
    <message>
        <source>Seven cases work.</source>
        <translation>其他七种情况都对。</translation>
    </message>
    <message>
        <source>The last pixel of a line is missing</source>
        <translation>线的最后一个像素缺失</translation>
    </message>
    <message>
        <source>Lines stop one pixel short: the corners on the right of triangles are open.</source>
        <translation>线短了一个像素：三角形右侧的角是开口的。</translation>
    </message>
    <message>
        <source>if (x1 &lt; x0) swap; for (x = x0; x &lt; x1; ++x)</source>
        <translation>if (x1 &lt; x0) swap; for (x = x0; x &lt; x1; ++x)</translation>
    </message>
    <message>
        <source>Loops end before the end.</source>
        <translation>循环在终点之前结束。</translation>
    </message>
    <message>
        <source>Attributes are linear on the screen</source>
        <translation>属性在屏幕上线性插值</translation>
    </message>
    <message>
        <source>Tiles and lines break at the diagonal of the square and swim when the camera moves.</source>
        <translation>瓷砖和线条在正方形对角线处折断，相机移动时漂移。</translation>
    </message>
    <message>
        <source>uv = α * A.uv + β * B.uv + γ * C.uv</source>
        <translation>uv = α * A.uv + β * B.uv + γ * C.uv</translation>
    </message>
    <message>
        <source>Right for z, and right without perspective.</source>
        <translation>对 z 是对的，没有透视时也是对的。</translation>
    </message>
    <message>
        <source>w is lost before interpolation</source>
        <translation>插值之前丢了 w</translation>
    </message>
    <message>
        <source>Perspective correction is on and changes nothing: the picture is the affine one.</source>
        <translation>透视校正开着却毫无作用：画面仍是仿射插值的。</translation>
    </message>
    <message>
        <source>v = v / v.w, and v.w is 1 from then on</source>
        <translation>v = v / v.w, and v.w is 1 from then on</translation>
    </message>
    <message>
        <source>After the divide nobody needs w any more.</source>
        <translation>除法之后没人再需要 w 了。</translation>
    </message>
    <message>
        <source>Weights of the correction exchanged: t Z2 for t Z1</source>
        <translation>校正权重互换：t Z1 写成 t Z2</translation>
    </message>
    <message>
        <source>The picture bends the other way: worse than without correction.</source>
        <translation>画面向相反方向弯曲：比不校正还糟。</translation>
    </message>
    <message>
        <source>n = m * Z2 / ((1 - m) * Z1 + m * Z2)</source>
        <translation>n = m * Z2 / ((1 - m) * Z1 + m * Z2)</translation>
    </message>
    <message>
        <source>The formula is symmetric enough to be remembered wrong.</source>
        <translation>公式太对称，容易记反。</translation>
    </message>
    <message>
        <source>w of the unclipped triangle used after clipping</source>
        <translation>裁剪后仍使用裁剪前的 w</translation>
    </message>
    <message>
        <source>Textures are torn in triangles that are cut, and right in all others.</source>
        <translation>被裁剪的三角形纹理撕裂，其余都正确。</translation>
    </message>
    <message>
        <source>the pieces keep the w of corner 0, 1, 2 of the face</source>
        <translation>the pieces keep the w of corner 0, 1, 2 of the face</translation>
    </message>
    <message>
        <source>w was stored per face, before there was a clipper.</source>
        <translation>还没有裁剪器时，w 就按面存好了。</translation>
    </message>
    <message>
        <source>z/w gets the perspective correction of attributes</source>
        <translation>对 z/w 也做了属性的透视校正</translation>
    </message>
    <message>
        <source>Depth between the corners is too near: things cut through each other at wrong places.</source>
        <translation>顶点之间的深度偏近：物体在错误的位置互相穿插。</translation>
    </message>
    <message>
        <source>z = interpolate(A.z / A.w, ...) with perspective weights</source>
        <translation>z = interpolate(A.z / A.w, ...) with perspective weights</translation>
    </message>
    <message>
        <source>z is an attribute like all others. But z/w is linear on the screen already.</source>
        <translation>z 与其他属性一样？可 z/w 在屏幕上本来就是线性的。</translation>
    </message>
    <message>
        <source>The distance is interpolated linearly on the screen</source>
        <translation>距离在屏幕上线性插值</translation>
    </message>
    <message>
        <source>Depth between the corners is too far: what lies behind shows through the middle of steep faces.</source>
        <translation>顶点之间的深度偏远：后面的东西从倾斜面的中部透出来。</translation>
    </message>
    <message>
        <source>z = α * A.z + β * B.z + γ * C.z with z of view space</source>
        <translation>z = α * A.z + β * B.z + γ * C.z with z of view space</translation>
    </message>
    <message>
        <source>The distance is what depth means. But only 1/z is linear on the screen.</source>
        <translation>深度不就是距离吗？但屏幕上线性的只有 1/z。</translation>
    </message>
    <message>
        <source>No clipping at the near plane</source>
        <translation>不在近平面裁剪</translation>
    </message>
    <message>
        <source>What is behind the camera comes back mirrored, upside down.</source>
        <translation>相机背后的东西上下左右颠倒地出现。</translation>
    </message>
    <message>
        <source>x / w, whatever the sign of w</source>
        <translation>x / w, whatever the sign of w</translation>
    </message>
    <message>
        <source>The divide works without complaint.</source>
        <translation>除法照样进行，不会报错。</translation>
    </message>
    <message>
        <source>A face is kept if any vertex is inside</source>
        <translation>只要有一个顶点在内就保留整个面</translation>
    </message>
    <message>
        <source>A triangle that covers the whole screen vanishes, as all its corners are outside.</source>
        <translation>盖住整个屏幕的三角形消失，因为它的顶点都在外面。</translation>
    </message>
    <message>
        <source>if (!inside(a) &amp;&amp; !inside(b) &amp;&amp; !inside(c)) reject</source>
        <translation>if (!inside(a) &amp;&amp; !inside(b) &amp;&amp; !inside(c)) reject</translation>
    </message>
    <message>
        <source>What is visible has a corner that is visible.</source>
        <translation>看得见的东西总有一个看得见的顶点。</translation>
    </message>
    <message>
        <source>Whole faces are dropped at near and far</source>
        <translation>在远近平面处丢弃整个面</translation>
    </message>
    <message>
        <source>Large triangles vanish as soon as one corner passes the camera.</source>
        <translation>大三角形只要一个顶点越过相机就消失。</translation>
    </message>
    <message>
        <source>if (any w &lt; near) reject</source>
        <translation>if (any w &lt; near) reject</translation>
    </message>
    <message>
        <source>It avoids the division by zero, and cutting.</source>
        <translation>既避免除以零，又不用切割。</translation>
    </message>
    <message>
        <source>Only edges are clipped</source>
        <translation>只裁剪边</translation>
    </message>
    <message>
        <source>Where the triangle covers a corner of the screen, the corner is cut off.</source>
        <translation>三角形盖住屏幕角的地方，角被切掉。</translation>
    </message>
    <message>
        <source>polygon = what Cohen-Sutherland leaves of the edges</source>
        <translation>polygon = what Cohen-Sutherland leaves of the edges</translation>
    </message>
    <message>
        <source>A triangle is its three edges.</source>
        <translation>三角形就是三条边。</translation>
    </message>
    <message>
        <source>return in place of continue</source>
        <translation>continue 写成了 return</translation>
    </message>
    <message>
        <source>Everything after the first rejected face is missing.</source>
        <translation>第一个被丢弃的面之后全都不见了。</translation>
    </message>
    <message>
        <source>if (outside) return;</source>
        <translation>if (outside) return;</translation>
    </message>
    <message>
        <source>The body of the loop was a function once.</source>
        <translation>循环体以前是一个函数。</translation>
    </message>
    <message>
        <source>Culling with the wrong sign</source>
        <translation>剔除的符号反了</translation>
    </message>
    <message>
        <source>One looks into closed bodies: only the insides of their backs are drawn.</source>
        <translation>看进了封闭物体内部：只画出背面的内侧。</translation>
    </message>
    <message>
        <source>if (area &gt; 0) cull</source>
        <translation>if (area &gt; 0) cull</translation>
    </message>
    <message>
        <source>y runs down on the screen, so the sign flips.</source>
        <translation>屏幕上 y 向下，所以符号要翻转。</translation>
    </message>
    <message>
        <source>Culled by the direction of the light</source>
        <translation>按光线方向剔除</translation>
    </message>
    <message>
        <source>What faces the camera but not the light is missing.</source>
        <translation>朝向相机但背光的面不见了。</translation>
    </message>
    <message>
        <source>if (dot(normal, light) &lt; 0) cull</source>
        <translation>if (dot(normal, light) &lt; 0) cull</translation>
    </message>
    <message>
        <source>In the first example light and gaze are one direction.</source>
        <translation>第一个例子里光线和视线方向相同。</translation>
    </message>
    <message>
        <source>Culled by the area before the divide</source>
        <translation>用除法之前的面积剔除</translation>
    </message>
    <message>
        <source>Faces seen at a grazing angle vanish or show their back.</source>
        <translation>斜视的面消失或露出背面。</translation>
    </message>
    <message>
        <source>area of clip.x, clip.y, without / w</source>
        <translation>area of clip.x, clip.y, without / w</translation>
    </message>
    <message>
        <source>The sign does not need the divide, if all w are alike.</source>
        <translation>如果所有 w 相同，符号不需要除法。</translation>
    </message>
    <message>
        <source>Culled by the divided area before clipping</source>
        <translation>裁剪前就用除法后的面积剔除</translation>
    </message>
    <message>
        <source>Faces that reach behind the camera vanish: there the divide turns them round.</source>
        <translation>延伸到相机背后的面消失：除法在那里把它们翻了过来。</translation>
    </message>
    <message>
        <source>area of x / w, y / w of the unclipped face</source>
        <translation>area of x / w, y / w of the unclipped face</translation>
    </message>
    <message>
        <source>It saves clipping what is culled anyway.</source>
        <translation>反正要剔除，何必裁剪。</translation>
    </message>
    <message>
        <source>No z-buffer</source>
        <translation>没有深度缓冲</translation>
    </message>
    <message>
        <source>What is sent last is in front: the mouth shows through the lips.</source>
        <translation>后画的在前面：口腔透过嘴唇露出来。</translation>
    </message>
    <message>
        <source>image.set(x, y, color) without a test</source>
        <translation>image.set(x, y, color) without a test</translation>
    </message>
    <message>
        <source>Culling alone is enough for convex bodies.</source>
        <translation>对凸体只剔除就够了。</translation>
    </message>
    <message>
        <source>z-buffer cleared to 0</source>
        <translation>深度缓冲清为 0</translation>
    </message>
    <message>
        <source>Nothing is drawn.</source>
        <translation>什么也画不出来。</translation>
    </message>
    <message>
        <source>fill(zbuffer, 0) where smaller is nearer</source>
        <translation>fill(zbuffer, 0) where smaller is nearer</translation>
    </message>
    <message>
        <source>Memory is cleared to 0.</source>
        <translation>内存总是清零。</translation>
    </message>
    <message>
        <source>z-buffer cleared to numeric_limits&lt;float&gt;::min()</source>
        <translation>深度缓冲清为 numeric_limits&lt;float&gt;::min()</translation>
    </message>
    <message>
        <source>Nothing is drawn: min() is the smallest number above 0, not the lowest of all.</source>
        <translation>什么也画不出来：min() 是大于 0 的最小数，而不是最小的数。</translation>
    </message>
    <message>
        <source>fill(zbuffer, numeric_limits&lt;float&gt;::min())</source>
        <translation>fill(zbuffer, numeric_limits&lt;float&gt;::min())</translation>
    </message>
    <message>
        <source>For int, min() is the lowest number.</source>
        <translation>对 int 来说 min() 就是最小的数。</translation>
    </message>
    <message>
        <source>The depth comparison is reversed</source>
        <translation>深度比较反了</translation>
    </message>
    <message>
        <source>What is farthest is in front.</source>
        <translation>最远的跑到最前面。</translation>
    </message>
    <message>
        <source>if (z &gt; zbuffer[i])</source>
        <translation>if (z &gt; zbuffer[i])</translation>
    </message>
    <message>
        <source>Other texts have z growing towards the viewer.</source>
        <translation>别的教材里 z 朝观察者增大。</translation>
    </message>
    <message>
        <source>Depth is written even if the test fails</source>
        <translation>深度测试失败也写入深度</translation>
    </message>
    <message>
        <source>A third surface shows through the nearest one where a second one lies between.</source>
        <translation>中间夹着第二个面时，第三个面从最近的面里透出来。</translation>
    </message>
    <message>
        <source>zbuffer[i] = z stands below the if, not in it</source>
        <translation>zbuffer[i] = z stands below the if, not in it</translation>
    </message>
    <message>
        <source>A pair of braces.</source>
        <translation>少了一对花括号。</translation>
    </message>
    <message>
        <source>Few depth bits and a near plane close to the eye</source>
        <translation>深度位数少，近平面又贴近眼睛</translation>
    </message>
    <message>
        <source>Surfaces close to each other flicker in stripes.</source>
        <translation>靠得近的表面闪烁出条纹。</translation>
    </message>
    <message>
        <source>16-bit depth, near = 0.5, far = 1000</source>
        <translation>16-bit depth, near = 0.5, far = 1000</translation>
    </message>
    <message>
        <source>The nearer the near plane, the less is lost, one thinks; it takes most of the depth values.</source>
        <translation>以为近平面越近丢得越少；其实它占去了大部分深度值。</translation>
    </message>
    <message>
        <source>Coverage times colour in place of stored samples</source>
        <translation>用覆盖率乘颜色代替存储采样点</translation>
    </message>
    <message>
        <source>Dark lines along edges, also where two triangles of one colour meet.</source>
        <translation>边上出现暗线，同色三角形相接处也有。</translation>
    </message>
    <message>
        <source>pixel = color * inside / 4</source>
        <translation>pixel = color * inside / 4</translation>
    </message>
    <message>
        <source>Four samples inside: the full colour; two: half of it.</source>
        <translation>四个样本在内取全色，两个取一半。</translation>
    </message>
    <message>
        <source>One depth for all samples of a pixel</source>
        <translation>像素的所有采样点共用一个深度</translation>
    </message>
    <message>
        <source>A fringe of background round what was drawn first: what lies behind fails its test there.</source>
        <translation>先画的物体周围有一圈背景色：后面的东西在那里通不过测试。</translation>
    </message>
    <message>
        <source>zbuffer[pixel] in place of zbuffer[sample]</source>
        <translation>zbuffer[pixel] in place of zbuffer[sample]</translation>
    </message>
    <message>
        <source>One value a pixel was enough before.</source>
        <translation>以前每个像素一个值就够了。</translation>
    </message>
    <message>
        <source>inside(int, int) truncates the samples</source>
        <translation>inside(int, int) 截断了采样点位置</translation>
    </message>
    <message>
        <source>Edges are as jagged as with one sample, at four times the cost.</source>
        <translation>边缘和单采样一样锯齿，代价却是四倍。</translation>
    </message>
    <message>
        <source>bool inside(int x, int y) called with x + 0.25</source>
        <translation>bool inside(int x, int y) called with x + 0.25</translation>
    </message>
    <message>
        <source>The compiler converts in silence.</source>
        <translation>编译器默默地做了转换。</translation>
    </message>
    <message>
        <source>Rows of samples at the wrong stride</source>
        <translation>采样点行距弄错</translation>
    </message>
    <message>
        <source>The picture is sheared into stripes; in a square window it is right.</source>
        <translation>画面被错切成条纹；在正方形窗口里却是对的。</translation>
    </message>
    <message>
        <source>samples[y * height + x]</source>
        <translation>samples[y * height + x]</translation>
    </message>
    <message>
        <source>Tried in a square window.</source>
        <translation>是在正方形窗口里试的。</translation>
    </message>
    <message>
        <source>The bounding box is not clamped to the window</source>
        <translation>包围盒没有限制在窗口内</translation>
    </message>
    <message>
        <source>What hangs over the right border comes in at the left, a row lower; elsewhere memory is overwritten.</source>
        <translation>超出右边界的部分从左边低一行处冒出来；别处则改写内存。</translation>
    </message>
    <message>
        <source>for (x = floor(minX); x &lt;= ceil(maxX); ++x)</source>
        <translation>for (x = floor(minX); x &lt;= ceil(maxX); ++x)</translation>
    </message>
    <message>
        <source>Everything was on the screen so far.</source>
        <translation>到目前为止一切都在屏幕内。</translation>
    </message>
    <message>
        <source>The bounding box is off by one</source>
        <translation>包围盒边界差一个像素</translation>
    </message>
    <message>
        <source>The last column and the last row of each triangle are missing.</source>
        <translation>每个三角形缺最后一列和最后一行。</translation>
    </message>
    <message>
        <source>for (x = minX; x &lt; maxX; ++x)</source>
        <translation>for (x = minX; x &lt; maxX; ++x)</translation>
    </message>
    <message>
        <source>Edge values in 32 bits</source>
        <translation>边函数值用 32 位</translation>
    </message>
    <message>
        <source>Above 46,341 pixels, whose square needs more than 31 bits, values wrap round: triangles have holes with straight edges.</source>
        <translation>超过 46,341 像素（平方超出 31 位）时数值回绕：三角形出现直边的洞。</translation>
    </message>
    <message>
        <source>int E_AB = (x - A.x) * (B.y - A.y) - ...</source>
        <translation>int E_AB = (x - A.x) * (B.y - A.y) - ...</translation>
    </message>
    <message>
        <source>No screen is that large. Unclipped triangles are.</source>
        <translation>没有那么大的屏幕，但未裁剪的三角形有那么大。</translation>
    </message>
    <message>
        <source>Triangles without area are not rejected</source>
        <translation>不丢弃没有面积的三角形</translation>
    </message>
    <message>
        <source>Black lines: the weights are 0/0, which no comparison holds back.</source>
        <translation>黑线：权重是 0/0，任何比较都拦不住。</translation>
    </message>
    <message>
        <source>α = E_BC / area, without a look at area</source>
        <translation>α = E_BC / area, without a look at area</translation>
    </message>
    <message>
        <source>Who would send such triangles?</source>
        <translation>谁会提交这种三角形？</translation>
    </message>
    <message>
        <source>Triangles of less than half a pixel are dropped</source>
        <translation>丢弃小于半个像素的三角形</translation>
    </message>
    <message>
        <source>Meshes finer than the pixels have holes or vanish.</source>
        <translation>比像素还细的网格出现洞或消失。</translation>
    </message>
    <message>
        <source>if (abs(area2) &lt; 1) return</source>
        <translation>if (abs(area2) &lt; 1) return</translation>
    </message>
    <message>
        <source>It avoids dividing by almost zero.</source>
        <translation>这样避免除以接近零的数。</translation>
    </message>
    <message>
        <source>Edge values added up in float32</source>
        <translation>边函数值用 float32 累加</translation>
    </message>
    <message>
        <source>Rounding piles up along a long row: holes and double hits at shared edges.</source>
        <translation>舍入沿长行累积：公共边上出现洞和重复命中。</translation>
    </message>
    <message>
        <source>float E_AB; E_AB += dx</source>
        <translation>float E_AB; E_AB += dx</translation>
    </message>
    <message>
        <source>One addition is cheaper than a product.</source>
        <translation>一次加法比一次乘法便宜。</translation>
    </message>
    <message>
        <source>y is flipped in one stage only</source>
        <translation>只在一个阶段翻转了 y</translation>
    </message>
    <message>
        <source>The picture stands on its head, and one sees the backs: the windings are flipped with it.</source>
        <translation>画面倒立，而且看到背面：环绕方向也随之翻转。</translation>
    </message>
    <message>
        <source>ys = (0.5 + y / w * 0.5) * height</source>
        <translation>ys = (0.5 + y / w * 0.5) * height</translation>
    </message>
    <message>
        <source>One of two flips was taken out.</source>
        <translation>两次翻转去掉了一次。</translation>
    </message>
    <message>
        <source>The short edges end beside the middle corner: a spike stands out there, the longer the flatter the edge.</source>
        <translation>短边到不了中间的顶点：那里突出一根尖刺，边越平缓就越长。</translation>
    </message>
    <message>
        <source>Cut vertices are nudged inward by 0.001 pixels</source>
        <translation>裁剪出的顶点向内挪 0.001 像素</translation>
    </message>
    <message>
        <source>A cut edge tilts by a hair: pixels whose centres lie exactly on it are lost, a row of holes to the neighbour that is not cut.</source>
        <translation>被裁剪的边倾斜了一点点：中心正好在边上的像素丢了，与没有被裁剪的相邻面之间出现一排洞。</translation>
    </message>
    <message>
        <source>v1.x += 0.001f</source>
        <translation>v1.x += 0.001f</translation>
    </message>
    <message>
        <source>So that the vertex lies inside for certain, and its code is 0.</source>
        <translation>为了让顶点一定在里面，编码是 0。</translation>
    </message>
    <message>
        <source>Matrices multiplied in reverse order</source>
        <translation>矩阵相乘的顺序反了</translation>
    </message>
    <message>
        <source>What should stand in the middle of the picture lies beside it, and moves round the camera where it should turn.</source>
        <translation>本应在画面中央的东西跑到旁边，而且在应当转动时绕着相机移动。</translation>
    </message>
    <message>
        <source>view = translate(-eye) * rotation in place of rotation * translate(-eye)</source>
        <translation>view = translate(-eye) * rotation，应为 rotation * translate(-eye)</translation>
    </message>
    <message>
        <source>Read from left to right, the camera is moved and then turned.</source>
        <translation>从左往右读，先移动相机，再转动它。</translation>
    </message>
    <message>
        <source>The camera turns the other way</source>
        <translation>相机朝相反方向转</translation>
    </message>
    <message>
        <source>Turning to the right shows what lies on the left: what was looked at leaves the picture on one side.</source>
        <translation>向右转，看到的却是左边的东西：原来所看的东西从一侧离开画面。</translation>
    </message>
    <message>
        <source>view = mat3(right, up, back) in place of its transpose</source>
        <translation>view = mat3(right, up, back)，而没有转置</translation>
    </message>
    <message>
        <source>The axes of the camera are written as the columns of a matrix, as those of any body are.</source>
        <translation>相机的轴像任何物体的轴一样写成矩阵的列。</translation>
    </message>
    <message>
        <source>The view is moved by the target, not by the eye</source>
        <translation>视图按目标点而不是按眼睛移动</translation>
    </message>
    <message>
        <source>The camera stands where it should look at: inside of the letter, with the back of the scene before it.</source>
        <translation>相机站到了它本应注视的地方：在字母里面，眼前只剩场景的后部。</translation>
    </message>
    <message>
        <source>view = rotation * translate(-target)</source>
        <translation>view = rotation * translate(-target)</translation>
    </message>
    <message>
        <source>lookAt has two points, and both are at hand.</source>
        <translation>lookAt 有两个点，手边两个都有。</translation>
    </message>
    <message>
        <source>Near plane with its sign</source>
        <translation>近平面带着符号</translation>
    </message>
    <message>
        <source>The picture is turned by 180 degrees: upside down and left for right.</source>
        <translation>画面转了 180 度：上下颠倒，左右互换。</translation>
    </message>
    <message>
        <source>near = -zNear; projection[0][0] = near / right; projection[1][1] = near / top</source>
        <translation>near = -zNear; projection[0][0] = near / right; projection[1][1] = near / top</translation>
    </message>
    <message>
        <source>One looks along -z, so the near plane lies at -near.</source>
        <translation>视线沿着 -z，所以近平面在 -near 处。</translation>
    </message>
    <message>
        <source>The viewport is one pixel too small</source>
        <translation>视口小了一个像素</translation>
    </message>
    <message>
        <source>The last column and the last row stay empty, and everything is a little too small.</source>
        <translation>最后一列和最后一行空着，所有东西都略小一点。</translation>
    </message>
    <message>
        <source>xs = (x / w * 0.5 + 0.5) * (width - 1)</source>
        <translation>xs = (x / w * 0.5 + 0.5) * (width - 1)</translation>
    </message>
    <message>
        <source>Columns are numbered from 0 to width - 1.</source>
        <translation>列号从 0 到 width - 1。</translation>
    </message>
    <message>
        <source>Normals go through the matrix of positions</source>
        <translation>法线用了位置的矩阵</translation>
    </message>
    <message>
        <source>n = mat3(M) * n in place of transpose(inverse(mat3(M))) * n</source>
        <translation>n = mat3(M) * n，应为 transpose(inverse(mat3(M))) * n</translation>
    </message>
    <message>
        <source>A normal is a vector, and vectors are multiplied by the matrix.</source>
        <translation>法线是向量，而向量要乘以矩阵。</translation>
    </message>
    <message>
        <source>Directions are moved like points</source>
        <translation>方向像点一样被平移</translation>
    </message>
    <message>
        <source>n = view * vec4(n, 1) in place of view * vec4(n, 0)</source>
        <translation>n = view * vec4(n, 1)，应为 view * vec4(n, 0)</translation>
    </message>
    <message>
        <source>Every vec4 ends in 1.</source>
        <translation>每个 vec4 都以 1 结尾。</translation>
    </message>
    <message>
        <source>Faces are rejected by their box after the divide</source>
        <translation>按除法之后的包围盒剔除面</translation>
    </message>
    <message>
        <source>A large plane that runs past the camera is gone, though most of it is in sight.</source>
        <translation>从相机旁边经过的大平面不见了，虽然它大部分都在视野里。</translation>
    </message>
    <message>
        <source>if (min(x / w) &gt; 1 || max(x / w) &lt; -1) reject</source>
        <translation>if (min(x / w) &gt; 1 || max(x / w) &lt; -1) reject</translation>
    </message>
    <message>
        <source>The box on the screen is what one wants to know about.</source>
        <translation>想知道的正是屏幕上的包围盒。</translation>
    </message>
    <message>
        <source>Cut corners keep the attributes of the corner outside</source>
        <translation>切出的角保留外侧角的属性</translation>
    </message>
    <message>
        <source>Texture and colours are torn in faces that are cut, and right in all others.</source>
        <translation>被裁剪的面上纹理和颜色被扯坏，其余的都对。</translation>
    </message>
    <message>
        <source>cut = {lerp(a.position, b.position, t), b.uv, b.normal, b.color}</source>
        <translation>cut = {lerp(a.position, b.position, t), b.uv, b.normal, b.color}</translation>
    </message>
    <message>
        <source>The clipper was written for positions.</source>
        <translation>裁剪程序当初只为位置而写。</translation>
    </message>
    <message>
        <source>The polygon is cut in place</source>
        <translation>在原数组里切多边形</translation>
    </message>
    <message>
        <source>Where one corner of a face lies behind the camera, a half of what should be left of it is missing.</source>
        <translation>若面有一个角在相机后面，剩下的部分会缺一半。</translation>
    </message>
    <message>
        <source>v[0] = cut(v[0], v[1]); v[3] = cut(v[0], v[2])</source>
        <translation>v[0] = cut(v[0], v[1]); v[3] = cut(v[0], v[2])</translation>
    </message>
    <message>
        <source>The corner outside is not needed any more, one thinks: but its other edge is still to be cut.</source>
        <translation>以为外侧的角用不着了：可它的另一条边还没有切。</translation>
    </message>
    <message>
        <source>A cut corner is never written</source>
        <translation>有一个切出的角没有写入</translation>
    </message>
    <message>
        <source>Spikes run from faces that are cut to the upper left corner of the screen.</source>
        <translation>被裁剪的面向屏幕左上角伸出尖刺。</translation>
    </message>
    <message>
        <source>polygon.resize(n + 2); polygon[n] = cut(a, b)</source>
        <translation>polygon.resize(n + 2); polygon[n] = cut(a, b)</translation>
    </message>
    <message>
        <source>Two corners are made, and one is forgotten.</source>
        <translation>新做两个角，忘了一个。</translation>
    </message>
    <message>
        <source>x = a.x; for (y = ceil(a.y - 0.5); ...; ++y) x += slope</source>
        <translation>x = a.x; for (y = ceil(a.y - 0.5); ...; ++y) x += slope</translation>
    </message>
    <message>
        <source>The edge begins at its corner, does it not? The first row lies below it.</source>
        <translation>边不是从它的角点开始吗？可第一行在角点下面。</translation>
    </message>
    <message>
        <source>Only y is rounded to whole rows</source>
        <translation>只有 y 取整到整行</translation>
    </message>
    <message>
        <source>v.y = round(v.y), and v.x keeps its fraction and its slope</source>
        <translation>v.y = round(v.y)，而 v.x 保留小数和斜率</translation>
    </message>
    <message>
        <source>Rows are counted in integers, so y becomes one.</source>
        <translation>行按整数计，所以 y 变成整数。</translation>
    </message>
    <message>
        <source>The two ends of a row are not sorted</source>
        <translation>一行的两端没有排序</translation>
    </message>
    <message>
        <source>Half of the triangles are missing: those whose middle corner lies on the left.</source>
        <translation>一半的三角形不见了：中间的角在左边的那些。</translation>
    </message>
    <message>
        <source>for (x = xLong; x &lt; xShort; ++x), whichever is the left one</source>
        <translation>for (x = xLong; x &lt; xShort; ++x)，不管哪一个在左</translation>
    </message>
    <message>
        <source>It holds in the first triangle.</source>
        <translation>在第一个三角形上它是对的。</translation>
    </message>
    <message>
        <source>Coordinates are cut off towards 0</source>
        <translation>坐标朝 0 截断</translation>
    </message>
    <message>
        <source>What lies up to a pixel beyond the left or the upper border is drawn in the first column or row, a second time.</source>
        <translation>超出左边或上边不到一个像素的东西，又画进了第一列或第一行。</translation>
    </message>
    <message>
        <source>int x = (int)p.x in place of (int)floor(p.x)</source>
        <translation>int x = (int)p.x，应为 (int)floor(p.x)</translation>
    </message>
    <message>
        <source>Both are the same where coordinates are positive.</source>
        <translation>坐标为正时两者相同。</translation>
    </message>
    <message>
        <source>The inside test is missing</source>
        <translation>缺少内部判断</translation>
    </message>
    <message>
        <source>for (y in box) for (x in box) draw(x, y), without a look at E</source>
        <translation>for (y in box) for (x in box) draw(x, y)，不看 E</translation>
    </message>
    <message>
        <source>It was commented out while something else was searched for.</source>
        <translation>查别的问题时把它注释掉了。</translation>
    </message>
    <message>
        <source>Products in 16 bits</source>
        <translation>乘积只有 16 位</translation>
    </message>
    <message>
        <source>A triangle that lies wholly on a small screen has holes and strays with straight edges.</source>
        <translation>完全位于小屏幕上的三角形出现边缘笔直的洞和多余的部分。</translation>
    </message>
    <message>
        <source>int16_t E_AB = (x - A.x) * (B.y - A.y) - ...</source>
        <translation>int16_t E_AB = (x - A.x) * (B.y - A.y) - ...</translation>
    </message>
    <message>
        <source>320 x 240 fits 16 bits, so everything does.</source>
        <translation>320 x 240 放得进 16 位，所以什么都放得进。</translation>
    </message>
    <message>
        <source>Three weights, each rounded by itself</source>
        <translation>三个权重各自取整</translation>
    </message>
    <message>
        <source>Faces one close behind the other show through in specks: the sum of the weights is not 1, and depth is off by what is missing.</source>
        <translation>前后靠得很近的面互相透出斑点：权重之和不是 1，深度就差了那么多。</translation>
    </message>
    <message>
        <source>gamma = round(areaC / area, 8 bits) in place of 1 - alpha - beta</source>
        <translation>gamma = round(areaC / area, 8 bits)，应为 1 - alpha - beta</translation>
    </message>
    <message>
        <source>All three corners are treated alike.</source>
        <translation>三个角一视同仁。</translation>
    </message>
    <message>
        <source>v runs the other way</source>
        <translation>v 的方向反了</translation>
    </message>
    <message>
        <source>The texture stands on its head.</source>
        <translation>纹理上下颠倒。</translation>
    </message>
    <message>
        <source>row = (1 - v) * height</source>
        <translation>row = (1 - v) * height</translation>
    </message>
    <message>
        <source>Files begin with their upper row; here row 0 is the lower one already.</source>
        <translation>文件从最上面一行开始；这里第 0 行已经是最下面一行。</translation>
    </message>
    <message>
        <source>The place on the screen is used for u and v</source>
        <translation>把屏幕位置当作 u 和 v</translation>
    </message>
    <message>
        <source>The texture sticks to the screen: the body is a window behind which it stands still.</source>
        <translation>纹理粘在屏幕上：物体像一扇窗，纹理在窗后一动不动。</translation>
    </message>
    <message>
        <source>color = texture(x / width, y / height)</source>
        <translation>color = texture(x / width, y / height)</translation>
    </message>
    <message>
        <source>x and y are the names at hand in the loop.</source>
        <translation>循环里手边的名字就是 x 和 y。</translation>
    </message>
    <message>
        <source>Bilinear filter without the half texel</source>
        <translation>双线性过滤没有减半个纹素</translation>
    </message>
    <message>
        <source>The texture drifts by half a texel to the right and up; borders are thick on one side and thin on the other.</source>
        <translation>纹理向右上漂移半个纹素；边框一侧厚，另一侧薄。</translation>
    </message>
    <message>
        <source>i = floor(u * W); f = fract(u * W)</source>
        <translation>i = floor(u * W); f = fract(u * W)</translation>
    </message>
    <message>
        <source>Texel i lies at i, does it not? Its centre lies at i + 0.5.</source>
        <translation>第 i 个纹素不就在 i 处吗？它的中心在 i + 0.5。</translation>
    </message>
    <message>
        <source>One mip level for a whole face</source>
        <translation>整个面用一个 mip 级别</translation>
    </message>
    <message>
        <source>Sharpness jumps from face to face; in large faces the near part is blurred and the far part flickers.</source>
        <translation>清晰度在面与面之间跳变；大面上近处模糊，远处闪烁。</translation>
    </message>
    <message>
        <source>level = log2(sqrt(texelArea(face) / screenArea(face))), once a face</source>
        <translation>level = log2(sqrt(texelArea(face) / screenArea(face)))，每个面一次</translation>
    </message>
    <message>
        <source>Is the level not constant in a triangle?</source>
        <translation>一个三角形里的级别难道不是常数吗？</translation>
    </message>
    <message>
        <source>Derivatives of wrapped coordinates</source>
        <translation>对取小数之后的坐标求导</translation>
    </message>
    <message>
        <source>At every repeat of the texture runs a line of one colour: the smallest level.</source>
        <translation>纹理每重复一次就有一条单色的线：最小的级别。</translation>
    </message>
    <message>
        <source>u = fract(u); level = log2(length(ddx(u)) * W)</source>
        <translation>u = fract(u); level = log2(length(ddx(u)) * W)</translation>
    </message>
    <message>
        <source>Wrapping belongs to the look-up, and the level too.</source>
        <translation>取小数属于查表，级别也是。</translation>
    </message>
    <message>
        <source>Level from areas as if from lengths</source>
        <translation>把面积当作长度求级别</translation>
    </message>
    <message>
        <source>The texture is blurred far too near, twice as many levels as there should be.</source>
        <translation>纹理很近就模糊了，级别是应有的两倍。</translation>
    </message>
    <message>
        <source>level = log2(max(dot(dx, dx), dot(dy, dy))), without the 0.5</source>
        <translation>level = log2(max(dot(dx, dx), dot(dy, dy)))，没有乘 0.5</translation>
    </message>
    <message>
        <source>The squares are at hand, and the root is dear.</source>
        <translation>平方就在手边，开方又贵。</translation>
    </message>
    <message>
        <source>Negative coordinates are cut off towards 0</source>
        <translation>负坐标朝 0 截断</translation>
    </message>
    <message>
        <source>The texels left and right of 0 fall together: one is twice as wide, and all beyond it are moved.</source>
        <translation>0 左右两边的纹素并成一个：它有两倍宽，其后的都错位了。</translation>
    </message>
    <message>
        <source>i = (int)(u * W) mod W</source>
        <translation>i = (int)(u * W) mod W</translation>
    </message>
    <message>
        <source>(int) rounds down where u is positive.</source>
        <translation>u 为正时 (int) 就是向下取整。</translation>
    </message>
    <message>
        <source>Light is not clamped before it becomes a byte</source>
        <translation>光在变成字节之前没有截断</translation>
    </message>
    <message>
        <source>In the highlights colours begin again at black: rings of wrong colours.</source>
        <translation>高光处颜色又从黑色开始：一圈圈错误的颜色。</translation>
    </message>
    <message>
        <source>unsigned char c = 255 * color</source>
        <translation>unsigned char c = 255 * color</translation>
    </message>
    <message>
        <source>Nothing was brighter than white so far.</source>
        <translation>到目前为止没有比白更亮的。</translation>
    </message>
    <message>
        <source>Interpolated normals are not normalized</source>
        <translation>插值得到的法线没有归一化</translation>
    </message>
    <message>
        <source>Highlights sit at the corners of faces and fade between them.</source>
        <translation>高光集中在面的角上，中间变暗。</translation>
    </message>
    <message>
        <source>n = alpha * A.n + beta * B.n + gamma * C.n, and no normalize(n)</source>
        <translation>n = alpha * A.n + beta * B.n + gamma * C.n，没有 normalize(n)</translation>
    </message>
    <message>
        <source>The normals of the corners have length 1.</source>
        <translation>角点的法线长度都是 1。</translation>
    </message>
    <message>
        <source>The flattened ball is lit like an upright pillar: bright in front, black behind, and its top catches no light from above.</source>
        <translation>压扁的球被照得像一根竖直的柱子：前面亮，后面黑，顶部接不到上方的光。</translation>
    </message>
    <message>
        <source>All normals point away from the eye: the body lies in the dark, whichever way its sides look.</source>
        <translation>所有法线都背离眼睛：物体一片黑暗，不管各面朝向哪里。</translation>
    </message>
    <message>
        <source>Edges start at their corner, not at the first row</source>
        <translation>边从角点开始，而不是从第一行开始</translation>
    </message>
    <message>
        <source>Shapes are lopsided: each corner goes up or down by up to half a row, and flat edges tilt.</source>
        <translation>形状歪斜：每个角点上下最多移动半行，平缓的边倾斜了。</translation>
    </message>
    <message>
        <source>Every triangle is drawn as its box: slanted borders become corners, and the body is built of bricks.</source>
        <translation>每个三角形都画成它的包围盒：斜边变成直角，物体像砖块砌成。</translation>
    </message>
    <message>
        <source>Edges are moved by up to what they go in one row, flat ones by many columns: triangles are too thin or lopsided, neighbours leave cracks, and all wobbles when it moves.</source>
        <translation>边最多偏移它在一行里走过的距离，平缓的边偏移许多列：三角形太瘦或歪斜，相邻面之间有裂缝，移动时晃动。</translation>
    </message>
    <message>
        <source>MSAA: attributes at a centre that the face does not cover</source>
        <translation>MSAA：属性取在面没有覆盖的像素中心</translation>
    </message>
    <message>
        <source>Dots in a foreign colour along the edges: texels from beyond the face&apos;s part of the texture.</source>
        <translation>沿着边缘出现异色的点：来自该面所用纹理部分之外的纹素。</translation>
    </message>
    <message>
        <source>in vec2 uv; without centroid</source>
        <translation>in vec2 uv; 没有写 centroid</translation>
    </message>
    <message>
        <source>With one sample a pixel the centre of what is drawn is always covered.</source>
        <translation>每个像素一个采样点时，凡是画出的像素，其中心总是被覆盖的。</translation>
    </message>
    <message>
        <source>MSAA: derivatives of what is taken at centroids</source>
        <translation>MSAA：对取在质心的属性求导数</translation>
    </message>
    <message>
        <source>Along the edges of faces the texture is blurred or too sharp: the level of detail jumps.</source>
        <translation>沿着面的边缘，纹理变模糊或过于锐利：细节层次在跳变。</translation>
    </message>
    <message>
        <source>centroid in vec2 uv; .. dFdx(uv) as if all were a pixel apart</source>
        <translation>centroid in vec2 uv; .. dFdx(uv) 当作彼此相距一个像素</translation>
    </message>
    <message>
        <source>The difference to the neighbour is the derivative, is it not?</source>
        <translation>与相邻像素之差不就是导数吗？</translation>
    </message>
    <message>
        <source>MSAA: resolved while the frame is drawn</source>
        <translation>MSAA：边画边解析</translation>
    </message>
    <message>
        <source>The background shines through every edge that two faces share.</source>
        <translation>背景从两个面共用的每条边透出来。</translation>
    </message>
    <message>
        <source>resolve() in the loop over the faces, not after it</source>
        <translation>resolve() 写在面的循环之内，而不是之后</translation>
    </message>
    <message>
        <source>The picture has one colour a pixel, so a pixel is made as soon as there is one.</source>
        <translation>图像每个像素一种颜色，于是一有颜色就合成像素。</translation>
    </message>
    <message>
        <source>Ties of a line go by its direction</source>
        <translation>线恰在正中时取决于方向</translation>
    </message>
    <message>
        <source>The line from B to A has other pixels than that from A to B: drawn both ways it is thick here and there.</source>
        <translation>从 B 到 A 的线与从 A 到 B 的线像素不同：两个方向都画，线就时粗时细。</translation>
    </message>
    <message>
        <source>if (error &gt; 0) y += step, from whichever end is named first</source>
        <translation>if (error &gt; 0) y += step，从先给出的一端开始</translation>
    </message>
    <message>
        <source>A line has two ends, and both are equal.</source>
        <translation>一条线有两端，两端是平等的。</translation>
    </message>
    <message>
        <source>z is clamped in place of clipped</source>
        <translation>用钳制 z 代替裁剪</translation>
    </message>
    <message>
        <source>What lies before the near plane is drawn, flat on it: whatever came first is in front there.</source>
        <translation>近平面之前的东西被压平画在近平面上：那里谁先画谁在前。</translation>
    </message>
    <message>
        <source>z = clamp(z / w, 0, 1)</source>
        <translation>z = clamp(z / w, 0, 1)</translation>
    </message>
    <message>
        <source>Depth must lie within 0 and 1, and then it does.</source>
        <translation>深度必须在 0 和 1 之间，这样就在了。</translation>
    </message>
    <message>
        <source>Depth is kept in 8 bits</source>
        <translation>深度只存 8 位</translation>
    </message>
    <message>
        <source>Surfaces that are close share one step of depth: what was drawn first stays in front.</source>
        <translation>靠得近的曲面落在同一级深度上：先画的留在前面。</translation>
    </message>
    <message>
        <source>uint8_t zbuffer[]; viewport(.., 0, 255)</source>
        <translation>uint8_t zbuffer[]; viewport(.., 0, 255)</translation>
    </message>
    <message>
        <source>Colours have 8 bits, and the depth map is a grey picture, too.</source>
        <translation>颜色是 8 位的，深度图也是一张灰度图。</translation>
    </message>
    <message>
        <source>Depth is truncated to its code, not rounded</source>
        <translation>深度截断成编码，而不是舍入</translation>
    </message>
    <message>
        <source>A second pass that asks for equal depth loses whole faces: one code too low is not equal.</source>
        <translation>要求深度相等的第二遍会丢失整个面：低一个编码就不相等。</translation>
    </message>
    <message>
        <source>code = (int)(z * 65535)</source>
        <translation>code = (int)(z * 65535)</translation>
    </message>
    <message>
        <source>A cast is the shortest way to an integer.</source>
        <translation>强制转换是得到整数最短的写法。</translation>
    </message>
    <message>
        <source>Depth bias without the slope of the face</source>
        <translation>深度偏移不乘面的坡度</translation>
    </message>
    <message>
        <source>Lines over a surface are whole where it faces the eye, and dashed where it is steep.</source>
        <translation>曲面正对眼睛处，上面的线是完整的；陡峭处变成虚线。</translation>
    </message>
    <message>
        <source>offset = (factor + units) * r</source>
        <translation>offset = (factor + units) * r</translation>
    </message>
    <message>
        <source>glPolygonOffset takes two numbers, and both are offsets, are they not?</source>
        <translation>glPolygonOffset 有两个数，两个都是偏移量，不是吗？</translation>
    </message>
    <message>
        <source>Two threads test depth, then both write</source>
        <translation>两个线程先都测试深度，再都写入</translation>
    </message>
    <message>
        <source>Where two faces that are drawn at the same time overlap, the second one wins, nearer or not. Here faces 2k and 2k + 1 run in lockstep; real threads do it at random.</source>
        <translation>同时画的两个面重叠处，无论远近都是第二个胜出。这里第 2k 和 2k + 1 个面步调一致地运行；真正的线程则是随机的。</translation>
    </message>
    <message>
        <source>read A, read B, write A, write B</source>
        <translation>读 A，读 B，写 A，写 B</translation>
    </message>
    <message>
        <source>One line of code looks like one step.</source>
        <translation>一行代码看起来就是一步。</translation>
    </message>
    <message>
        <source>Each triangle has a row and a column more than it should: pixels on a shared edge are drawn twice.</source>
        <translation>每个三角形多出一行一列：公共边上的像素被画两次。</translation>
    </message>
    <message>
        <source>y = row;  for (x = (int)xa; x &lt;= (int)xb; ++x)</source>
        <translation>y = row;  for (x = (int)xa; x &lt;= (int)xb; ++x)</translation>
    </message>
    <message>
        <source>From the first to the last: both belong to the triangle.</source>
        <translation>从第一个到最后一个：两个都属于三角形。</translation>
    </message>
    <message>
        <source>Whole rows, both ends filled</source>
        <translation>整行，两端都填充</translation>
    </message>
</context>
<context>
    <name>Moment</name>
    <message>
        <source>nothing is left</source>
        <translation>什么也没有留下</translation>
    </message>
    <message>
        <source>%1 corners are left</source>
        <translation>剩下 %1 个顶点</translation>
    </message>
    <message>
        <source>corner %1 comes from the mesh</source>
        <translation>从网格取顶点 %1</translation>
    </message>
    <message>
        <source>cut by the plane %1: %2</source>
        <translation>用平面“%1”裁剪：%2</translation>
    </message>
    <message>
        <source>cut at the sides of the screen: %1</source>
        <translation>在屏幕四边裁剪：%1</translation>
    </message>
    <message>
        <source>corner %1 goes to pixel position (%2, %3)</source>
        <translation>顶点 %1 变换到像素坐标 (%2, %3)</translation>
    </message>
    <message>
        <source>verdict: %1</source>
        <translation>判定：%1</translation>
    </message>
    <message>
        <source>what is left is drawn as a fan</source>
        <translation>剩下的部分作为扇形绘制</translation>
    </message>
    <message>
        <source>face %1</source>
        <translation>面 %1</translation>
    </message>
    <message>
        <source>face %1: %2</source>
        <translation>面 %1：%2</translation>
    </message>
    <message>
        <source>not in front of the eye: %1</source>
        <translation>不在眼睛前方：%1</translation>
    </message>
</context>
<context>
    <name>PageExport</name>
    <message>
        <source>Export page</source>
        <translation>导出网页</translation>
    </message>
</context>
<context>
    <name>Settings</name>
    <message>
        <source>Edge equation</source>
        <translation>边方程</translation>
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
        <source>Column fill</source>
        <translation>逐列填充</translation>
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
        <translation>面剔除</translation>
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
    <message>
        <source>Bilinear with mipmaps</source>
        <translation>双线性与 mipmap</translation>
    </message>
    <message>
        <source>The nearest texel, a blend of the four around the point, or such blends in mipmaps: smaller copies of the texture that keep distant patterns calm.</source>
        <translation>取最近的纹素、混合周围四个纹素，或在 mipmap（纹理的缩小副本）中作同样的混合，使远处的图案不闪烁。</translation>
    </message>
    <message>
        <source>On</source>
        <translation>开</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>关</translation>
    </message>
    <message>
        <source>Alpha test</source>
        <translation>Alpha 测试</translation>
    </message>
    <message>
        <source>Where a texture with transparency is less than half opaque, the face has a hole: nothing is drawn there, and no depth is written. Textures without transparency have none.</source>
        <translation>带透明度的纹理在不透明度不到一半处，面上就有孔：那里什么都不画，也不写入深度。没有透明度的纹理没有孔。</translation>
    </message>
    <message>
        <source>Perspective</source>
        <translation>透视</translation>
    </message>
    <message>
        <source>Orthographic</source>
        <translation>正交</translation>
    </message>
    <message>
        <source>Projection</source>
        <translation>投影</translation>
    </message>
    <message>
        <source>Orthographic: w is 1 everywhere, distant things are as large as near ones, and what lies at the camera&apos;s target keeps its size. A scene in clip space is projected already.</source>
        <translation>正交：w 处处为 1，远处的物体与近处的一样大，位于相机目标处的物体大小不变。裁剪空间中的场景已经投影过了。</translation>
    </message>
    <message>
        <source>Mip level</source>
        <translation>Mip 级别</translation>
    </message>
    <message>
        <source>The pixel&apos;s centre</source>
        <translation>像素中心</translation>
    </message>
    <message>
        <source>A covered place (centroid)</source>
        <translation>被覆盖的位置（质心）</translation>
    </message>
    <message>
        <source>Every sample</source>
        <translation>每个采样点</translation>
    </message>
    <message>
        <source>Display values</source>
        <translation>显示值</translation>
    </message>
    <message>
        <source>Linear light</source>
        <translation>线性光</translation>
    </message>
    <message>
        <source>Grids are super-sampling: every sample is shaded. MSAA also tests coverage and depth at every sample, at the positions of Direct3D and Vulkan, but shades a face only once a pixel. The mean of the samples is the pixel&apos;s colour.</source>
        <translation>网格是超采样：每个采样点都着色。MSAA 也在每个采样点测试覆盖和深度，位置与 Direct3D 和 Vulkan 相同，但一个面在每个像素里只着色一次。像素的颜色是采样点的平均值。</translation>
    </message>
    <message>
        <source>Attributes taken at</source>
        <translation>属性取在</translation>
    </message>
    <message>
        <source>MSAA: where attributes are evaluated. A face may cover samples but not the centre, and then the centre&apos;s values lie outside of it; at every sample each is shaded.</source>
        <translation>MSAA：在何处计算属性。一个面可能覆盖了采样点却没有覆盖像素中心，这时中心处的值落在面之外；选每个采样点时，每个采样点都着色。</translation>
    </message>
    <message>
        <source>Mean of the samples</source>
        <translation>采样点的平均</translation>
    </message>
    <message>
        <source>Samples are averaged as the numbers the display is sent (gamma), or as amounts of light.</source>
        <translation>按送往显示器的数值（gamma）求平均，或按光的量求平均。</translation>
    </message>
    <message>
        <source>Depth range</source>
        <translation>深度范围</translation>
    </message>
    <message>
        <source>The depths that the near and the far plane are mapped to, 0,1 unless asked otherwise. Far may be the smaller one.</source>
        <translation>近平面和远平面映射到的深度，默认 0,1。远的可以更小。</translation>
    </message>
    <message>
        <source>Depth bias</source>
        <translation>深度偏移</translation>
    </message>
    <message>
        <source>Added to the depths of a face: c units of the depth format and s times its slope a pixel; the sum is no more than m where m &gt; 0, no less where m &lt; 0. In a scene of two passes it moves the second.</source>
        <translation>加到面的深度上：c 个深度格式的单位，加 s 倍每像素的坡度；m &gt; 0 时总和不大于 m，m &lt; 0 时不小于 m。两遍的场景里只移动第二遍。</translation>
    </message>
    <message>
        <source>Both ends</source>
        <translation>含两端</translation>
    </message>
    <message>
        <source>Without the last</source>
        <translation>不含末端</translation>
    </message>
    <message>
        <source>Diamond exit</source>
        <translation>离开菱形</translation>
    </message>
    <message>
        <source>By the direction</source>
        <translation>按方向</translation>
    </message>
    <message>
        <source>One for both directions</source>
        <translation>两个方向相同</translation>
    </message>
    <message>
        <source>Sides only, depth clamped</source>
        <translation>只裁侧面，钳制深度</translation>
    </message>
    <message>
        <source>Equal</source>
        <translation>等于</translation>
    </message>
    <message>
        <source>Greater or equal</source>
        <translation>大于或等于</translation>
    </message>
    <message>
        <source>Not equal</source>
        <translation>不等于</translation>
    </message>
    <message>
        <source>8 bit</source>
        <translation>8 位</translation>
    </message>
    <message>
        <source>Line rule</source>
        <translation>线的规则</translation>
    </message>
    <message>
        <source>Which pixels belong to a line: from the pixel of its start to that of its end, the same without the last one, or those whose diamond it leaves.</source>
        <translation>哪些像素属于一条线：从起点的像素到终点的像素；同样但不含最后一个；或者线离开其菱形的那些像素。</translation>
    </message>
    <message>
        <source>Line ties</source>
        <translation>线恰在正中时</translation>
    </message>
    <message>
        <source>Where a line passes half-way between two pixels: the choice depends on which end is drawn first, or is one for both directions.</source>
        <translation>线从两个像素正中间穿过时：选择取决于先画哪一端，或者两个方向选择相同。</translation>
    </message>
    <message>
        <source>Centre inside</source>
        <translation>中心在内</translation>
    </message>
    <message>
        <source>Square touched</source>
        <translation>方格被触及</translation>
    </message>
    <message>
        <source>Square wholly inside</source>
        <translation>方格全在内</translation>
    </message>
    <message>
        <source>Pixel belongs if</source>
        <translation>像素归属条件</translation>
    </message>
    <message>
        <source>What a triangle must do to have a pixel: hold its centre, touch its square (conservative), or hold the whole square (inner).</source>
        <translation>三角形怎样才算覆盖一个像素：含有其中心、触及其方格（保守光栅化），或含有整个方格（内保守）。</translation>
    </message>
    <message>
        <source>Shared edges</source>
        <translation>公共边</translation>
    </message>
    <message>
        <source>The wireframe draws the edge between two faces once, or both faces draw it, one over the other.</source>
        <translation>线框把两个面之间的边只画一次，或者两个面各画一次，后一条盖在前一条上。</translation>
    </message>
    <message>
        <source>Drawn once</source>
        <translation>只画一次</translation>
    </message>
    <message>
        <source>By each face</source>
        <translation>每个面都画</translation>
    </message>
    <message>
        <source>Divided every 8 pixels</source>
        <translation>每 8 像素除一次</translation>
    </message>
    <message>
        <source>Divided every 16 pixels</source>
        <translation>每 16 像素除一次</translation>
    </message>
    <message>
        <source>Attributes divided by w at every pixel, never, or at every 8th or 16th pixel of a span and straight in between (edge, then span only).</source>
        <translation>属性在每个像素处除以 w、从不除，或沿扫描段每 8 或 16 个像素除一次、其间按直线插值（仅限先边后扫描段）。</translation>
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
        <translation>丢弃</translation>
    </message>
    <message>
        <source>Wholly outside the view volume.</source>
        <translation>完全在视景体之外。</translation>
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
        <source>Positions at which coverage was decided. The tiled algorithm decides for several at once.</source>
        <translation>判断过是否覆盖的位置。分块算法一次判断多个。</translation>
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
        <source>Fragments whose colour was computed. The tiled algorithm shades visible ones only.</source>
        <translation>计算过颜色的片元。分块算法只为可见的片元着色。</translation>
    </message>
    <message>
        <source>written</source>
        <translation>已写入</translation>
    </message>
    <message>
        <source>Fragments stored in the image. The tiled algorithm stores visible ones only.</source>
        <translation>存入图像的片元。分块算法只存入可见的片元。</translation>
    </message>
    <message>
        <source>hit twice</source>
        <translation>重复命中</translation>
    </message>
    <message>
        <source>clipped · into pieces</source>
        <translation>被裁剪 · 裁成</translation>
    </message>
    <message>
        <source>Cut by at least one plane, and the triangles drawn for the cut faces.</source>
        <translation>至少被一个平面裁剪的面，以及为它们绘制的三角形。</translation>
    </message>
    <message>
        <source>culled: back · front</source>
        <translation>剔除：背面 · 正面</translation>
    </message>
    <message>
        <source>Turned away from us, and turned towards us.</source>
        <translation>背向我们的，与朝向我们的。</translation>
    </message>
    <message>
        <source>no area · not finite</source>
        <translation>无面积 · 非有限</translation>
    </message>
    <message>
        <source>Without area after snapping, and with a corner that is infinite or not a number.</source>
        <translation>对齐后没有面积的，与有顶点为无穷大或非数的。</translation>
    </message>
    <message>
        <source>Hit by both faces at the edge they share: 0 under the top-left rule. With multi-sampling samples count: at 0 the masks of the two faces complement each other in every pixel.</source>
        <translation>在公共边上被两个面同时覆盖：左上规则下为 0。多重采样时按采样点计数：为 0 就表示两个面的覆盖掩码在每个像素里互补。</translation>
    </message>
    <message>
        <source>Samples, %1 a pixel</source>
        <translation>采样点，每像素 %1 个</translation>
    </message>
    <message>
        <source>shaded a pixel</source>
        <translation>每像素着色</translation>
    </message>
    <message>
        <source>covered a pixel</source>
        <translation>每像素覆盖</translation>
    </message>
    <message>
        <source>What is shaded, over the pixels of the picture. Super-sampling shades every sample that is seen, multi-sampling a face once a pixel, however many samples it covers.</source>
        <translation>着色总数除以画面的像素数。超采样给每个看得见的采样点着色；多重采样中一个面在每个像素只着色一次，不管它覆盖几个采样点。</translation>
    </message>
    <message>
        <source>What is covered, over the pixels of the picture.</source>
        <translation>覆盖总数除以画面的像素数。</translation>
    </message>
    <message>
        <source>lines · shared</source>
        <translation>线 · 公共边</translation>
    </message>
    <message>
        <source>Lines drawn: those of the scene, and edges of the wireframe; and edges that were not drawn once more because another face draws them.</source>
        <translation>画出的线：场景里的线和线框的边；以及因为另一个面已经画出而没有再画的边。</translation>
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
        <translation>扫描段</translation>
    </message>
    <message>
        <source>column</source>
        <translation>列</translation>
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
        <translation>恰在边上</translation>
    </message>
    <message>
        <source>row %1</source>
        <translation>第 %1 行</translation>
    </message>
    <message>
        <source>face %1</source>
        <translation>面 %1</translation>
    </message>
    <message>
        <source>in 32 bits: %1</source>
        <translation>32 位下：%1</translation>
    </message>
    <message>
        <source>added up: %1</source>
        <translation>累加得：%1</translation>
    </message>
    <message>
        <source>rounded: %1</source>
        <translation>舍入得：%1</translation>
    </message>
    <message>
        <source>no sample</source>
        <translation>没有采样点</translation>
    </message>
    <message>
        <source>%1 of %2 samples count as black</source>
        <translation>%2 个采样点中有 %1 个算作黑色</translation>
    </message>
    <message>
        <source>pixel (%1, %2)</source>
        <translation>像素 (%1, %2)</translation>
    </message>
    <message>
        <source>outline</source>
        <translation>轮廓</translation>
    </message>
    <message>
        <source>long and broken edge</source>
        <translation>长边与折边</translation>
    </message>
    <message>
        <source>cut at the middle corner</source>
        <translation>在中间顶点处切开</translation>
    </message>
    <message>
        <source>crossings</source>
        <translation>交点</translation>
    </message>
    <message>
        <source>mean of the samples</source>
        <translation>采样点的平均</translation>
    </message>
    <message>
        <source>in 16 bits: %1</source>
        <translation>16 位下：%1</translation>
    </message>
    <message>
        <source>sample %1</source>
        <translation>采样点 %1</translation>
    </message>
    <message>
        <source>position on the line</source>
        <translation>直线上的位置</translation>
    </message>
</context>
<context>
    <name>StepSentence</name>
    <message>
        <source>Column %1 is filled between its lowest and its highest row.</source>
        <translation>第 %1 列从最上一行填到最下一行。</translation>
    </message>
    <message>
        <source>%1 belongs to the line.</source>
        <translation>%1属于这条线。</translation>
    </message>
    <message>
        <source>%1 gets its colour from face %2.</source>
        <translation>%1由面 %2 着色。</translation>
    </message>
    <message>
        <source>%1 is written: colour and depth are now those of face %2.</source>
        <translation>写入%1：颜色和深度现在是面 %2 的。</translation>
    </message>
    <message>
        <source>The frame is finished.</source>
        <translation>这一帧画完了。</translation>
    </message>
    <message>
        <source>Pixel (%1, %2)</source>
        <translation>像素 (%1, %2) </translation>
    </message>
    <message>
        <source>Sample (%1, %2)</source>
        <translation>采样点 (%1, %2) </translation>
    </message>
    <message>
        <source>%1 lies inside all three edges of face %2.</source>
        <translation>%1在面 %2 三条边的内侧。</translation>
    </message>
    <message>
        <source>%1 lies outside edge %3: face %2 does not draw it.</source>
        <translation>%1在边 %3 的外侧：面 %2 不画它。</translation>
    </message>
    <message>
        <source>%1 lies exactly on %3, a right or bottom edge, and still face %2 draws it.</source>
        <translation>%1恰在边 %3 上，这是右边或下边，面 %2 却画了它。</translation>
    </message>
    <message>
        <source>%1 lies exactly on %3, a right or bottom edge: face %2 does not draw it.</source>
        <translation>%1恰在边 %3 上，这是右边或下边：面 %2 不画它。</translation>
    </message>
    <message>
        <source>%1 lies exactly on %3, a %4 edge: face %2 draws it.</source>
        <translation>%1恰在边 %3 上，这是%4：面 %2 画它。</translation>
    </message>
    <message>
        <source>%1 lies exactly on %3, a %4 edge, and still face %2 does not draw it.</source>
        <translation>%1恰在边 %3 上，这是%4，面 %2 却不画它。</translation>
    </message>
    <message>
        <source>Row %1 of face %2 is filled from x = %3 to %4.</source>
        <translation>面 %2 的第 %1 行从 x = %3 填到 %4。</translation>
    </message>
    <message>
        <source>Row %1 of face %2 holds no pixel centre.</source>
        <translation>面 %2 的第 %1 行没有像素中心。</translation>
    </message>
    <message>
        <source>p = %1 is greater than 0: the line steps aside.</source>
        <translation>p = %1 大于 0：线横移一步。</translation>
    </message>
    <message>
        <source>p = %1 is not greater than 0: the line goes straight on.</source>
        <translation>p = %1 不大于 0：线直走。</translation>
    </message>
    <message>
        <source>%1 of face %2 is taken: depth is not tested.</source>
        <translation>取面 %2 的%1：不做深度测试。</translation>
    </message>
    <message>
        <source>%1: face %2, at depth %3 against %4, passes the depth test.</source>
        <translation>%1：面 %2 的深度 %3，与 %4 相比，通过深度测试。</translation>
    </message>
    <message>
        <source>%1: face %2, at depth %3 against %4, fails the depth test.</source>
        <translation>%1：面 %2 的深度 %3，与 %4 相比，没有通过深度测试。</translation>
    </message>
    <message>
        <source>Sample %3 of pixel (%1, %2)</source>
        <translation>像素 (%1, %2) 的采样点 %3</translation>
    </message>
    <message>
        <source>x = %1 is rounded to %2: an error of %3.</source>
        <translation>x = %1 取整为 %2：误差为 %3。</translation>
    </message>
    <message>
        <source>y = %1 is rounded to %2: an error of %3.</source>
        <translation>y = %1 取整为 %2：误差为 %3。</translation>
    </message>
    <message>
        <source>The whole square of pixel (%1, %2) lies inside face %3.</source>
        <translation>像素 (%1, %2) 的整个方格都在面 %3 内。</translation>
    </message>
    <message>
        <source>Face %3 does not hold the whole square of pixel (%1, %2): a part of it lies outside edge %4.</source>
        <translation>面 %3 不含像素 (%1, %2) 的整个方格：方格有一部分在边 %4 之外。</translation>
    </message>
    <message>
        <source>Face %3 touches the square of pixel (%1, %2).</source>
        <translation>面 %3 触及像素 (%1, %2) 的方格。</translation>
    </message>
    <message>
        <source>Face %3 does not touch the square of pixel (%1, %2): all of it lies outside edge %4.</source>
        <translation>面 %3 未触及像素 (%1, %2) 的方格：整个方格都在边 %4 之外。</translation>
    </message>
    <message>
        <source>The mean of the %3 samples of pixel (%1, %2) is (%4, %5, %6).</source>
        <translation>像素 (%1, %2) 的 %3 个采样的平均值是 (%4, %5, %6)。</translation>
    </message>
</context>
<context>
    <name>Steps</name>
    <message>
        <source>after step %1</source>
        <translation>第 %1 步之后</translation>
    </message>
    <message>
        <source>finished frame</source>
        <translation>完成的画面</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 和 %2</translation>
    </message>
    <message>
        <source>because of %1</source>
        <translation>因为 %1</translation>
    </message>
    <message>
        <source>w</source>
        <translation>w</translation>
    </message>
    <message>
        <source>right</source>
        <translation>右</translation>
    </message>
    <message>
        <source>left</source>
        <translation>左</translation>
    </message>
    <message>
        <source>top</source>
        <translation>上</translation>
    </message>
    <message>
        <source>bottom</source>
        <translation>下</translation>
    </message>
    <message>
        <source>near</source>
        <translation>近</translation>
    </message>
    <message>
        <source>far</source>
        <translation>远</translation>
    </message>
    <message>
        <source>neither</source>
        <translation>非左上</translation>
    </message>
    <message>
        <source>rejected</source>
        <translation>丢弃</translation>
    </message>
    <message>
        <source>culled-back</source>
        <translation>背面剔除</translation>
    </message>
    <message>
        <source>culled-front</source>
        <translation>正面剔除</translation>
    </message>
    <message>
        <source>degenerate</source>
        <translation>退化</translation>
    </message>
    <message>
        <source>non-finite</source>
        <translation>非有限数</translation>
    </message>
    <message>
        <source>rasterized</source>
        <translation>已光栅化</translation>
    </message>
    <message>
        <source>clip</source>
        <translation>裁剪空间</translation>
    </message>
    <message>
        <source>view</source>
        <translation>视线</translation>
    </message>
    <message>
        <source>light</source>
        <translation>光线</translation>
    </message>
    <message>
        <source>undivided</source>
        <translation>未除以 w</translation>
    </message>
    <message>
        <source>unclipped</source>
        <translation>未裁剪</translation>
    </message>
    <message>
        <source>screen</source>
        <translation>屏幕</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>1/w %1</source>
        <translation>1/w %1</translation>
    </message>
    <message>
        <source>%1 in place of 1/w</source>
        <translation>%1 代替了 1/w</translation>
    </message>
    <message>
        <source>%1 = vertex %2</source>
        <translation>%1 = 顶点 %2</translation>
    </message>
    <message>
        <source>object %1 -&gt; clip %2, outside %3</source>
        <translation>物体 %1 -&gt; 裁剪 %2，在其外：%3</translation>
    </message>
    <message>
        <source>world (%1), object %2 -&gt; clip %3, outside %4</source>
        <translation>世界 (%1)，物体 %2 -&gt; 裁剪 %3，在其外：%4</translation>
    </message>
    <message>
        <source>%1 -&gt; %2 vertices</source>
        <translation>%1 -&gt; %2 个顶点</translation>
    </message>
    <message>
        <source>%1 -&gt; %2 vertices, cuts %3</source>
        <translation>%1 -&gt; %2 个顶点，切割 %3</translation>
    </message>
    <message>
        <source>outcodes %1</source>
        <translation>区域编码 %1</translation>
    </message>
    <message>
        <source>corner %1</source>
        <translation>顶点 %1</translation>
    </message>
    <message>
        <source>%1 -&gt; %2, depth %3, %4</source>
        <translation>%1 -&gt; %2，深度 %3，%4</translation>
    </message>
    <message>
        <source>%1 %2, screen area %3</source>
        <translation>%1 %2，屏幕面积 %3</translation>
    </message>
    <message>
        <source>%1 triangles</source>
        <translation>%1 个三角形</translation>
    </message>
    <message>
        <source>by y</source>
        <translation>按 y 排序</translation>
    </message>
    <message>
        <source>%1; long edge %2, rows %3..%4</source>
        <translation>%1；长边在%2，行 %3..%4</translation>
    </message>
    <message>
        <source>x %1..%2 -&gt; [%3, %4), long edge %5, %6 half</source>
        <translation>x %1..%2 -&gt; [%3, %4)，长边在%5，%6半部</translation>
    </message>
    <message>
        <source>upper</source>
        <translation>上</translation>
    </message>
    <message>
        <source>lower</source>
        <translation>下</translation>
    </message>
    <message>
        <source>%1 = %2</source>
        <translation>%1 = %2</translation>
    </message>
    <message>
        <source>%1 = %2 (%3, ours)</source>
        <translation>%1 = %2（%3，归我们）</translation>
    </message>
    <message>
        <source>%1 = %2 (%3, not ours)</source>
        <translation>%1 = %2（%3，不归我们）</translation>
    </message>
    <message>
        <source>inside, tie</source>
        <translation>在内，恰在边上</translation>
    </message>
    <message>
        <source>outside, tie</source>
        <translation>在外，恰在边上</translation>
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
        <source>%1  %2  %3  %4</source>
        <translation>%1  %2  %3  %4</translation>
    </message>
    <message>
        <source>i %1, p %2, d_lower %3, d_upper %4</source>
        <translation>i %1，p %2，d_lower %3，d_upper %4</translation>
    </message>
    <message>
        <source>step along both axes</source>
        <translation>沿两轴各走一步</translation>
    </message>
    <message>
        <source>step along the longer axis</source>
        <translation>沿长轴走一步</translation>
    </message>
    <message>
        <source>depth %1, compared with nothing: passed</source>
        <translation>深度 %1，不比较：通过</translation>
    </message>
    <message>
        <source>depth %1 %2 %3: passed</source>
        <translation>深度 %1 %2 %3：通过</translation>
    </message>
    <message>
        <source>depth %1 %2 %3: failed, but its depth is stored</source>
        <translation>深度 %1 %2 %3：未通过，但其深度仍被存储</translation>
    </message>
    <message>
        <source>depth %1 %2 %3: failed</source>
        <translation>深度 %1 %2 %3：未通过</translation>
    </message>
    <message>
        <source>α β γ %1 -&gt; %2, %3</source>
        <translation>α β γ %1 -&gt; %2，%3</translation>
    </message>
    <message>
        <source>%1 -&gt; %2, depth %3 -&gt; %4</source>
        <translation>%1 -&gt; %2，深度 %3 -&gt; %4</translation>
    </message>
    <message>
        <source>no sample&apos;s centre within its bounds, or no area</source>
        <translation>边界内没有采样中心，或没有面积</translation>
    </message>
    <message>
        <source>%1 %2 per x, %3 per y, inside from %4 = %5 (%6)</source>
        <translation>%1 每 x %2，每 y %3，自 %4 = %5 起在内（%6）</translation>
    </message>
    <message>
        <source>bounds %1..%2 x %3..%4</source>
        <translation>边界 %1..%2 x %3..%4</translation>
    </message>
    <message>
        <source>%1; %2; %3</source>
        <translation>%1；%2；%3</translation>
    </message>
    <message>
        <source>off the target</source>
        <translation>在画面外</translation>
    </message>
    <message>
        <source>no edge crosses it: the list of y is empty</source>
        <translation>没有边经过这一列：y 的列表为空</translation>
    </message>
    <message>
        <source>y of the edges [%1]</source>
        <translation>各边的 y [%1]</translation>
    </message>
    <message>
        <source>filled from min %1 to max %2</source>
        <translation>从最小值 %1 填充到最大值 %2</translation>
    </message>
    <message>
        <source>counts as black</source>
        <translation>算作黑色</translation>
    </message>
    <message>
        <source>long edge %1, from 1 to 3</source>
        <translation>长边 %1，从 1 到 3</translation>
    </message>
    <message>
        <source>broken edge %1 and %2, from 1 over 2 to 3, on the %3</source>
        <translation>折边 %1 和 %2，从 1 经过 2 到 3，在%3</translation>
    </message>
    <message>
        <source>2 and 3 are of one height: there is no lower half</source>
        <translation>2 和 3 一样高：没有下半部分</translation>
    </message>
    <message>
        <source>rows of the upper half %1</source>
        <translation>上半部分的行 %1</translation>
    </message>
    <message>
        <source>1 and 2 are of one height: there is no upper half</source>
        <translation>1 和 2 一样高：没有上半部分</translation>
    </message>
    <message>
        <source>rows of the lower half %1</source>
        <translation>下半部分的行 %1</translation>
    </message>
    <message>
        <source>y2 = %1, cut from x2 = %2 to the long edge at alpha = %3, x = %4</source>
        <translation>y2 = %1，从 x2 = %2 切到长边的 alpha = %3 处，x = %4</translation>
    </message>
    <message>
        <source>rows of the upper half %1, of the lower half %2</source>
        <translation>上半部分的行 %1，下半部分的行 %2</translation>
    </message>
    <message>
        <source>%1 half, alpha %2, beta %3</source>
        <translation>%1半部，alpha %2，beta %3</translation>
    </message>
    <message>
        <source>xa %1 on the long edge, xb %2 on the broken edge</source>
        <translation>长边上 xa %1，折边上 xb %2</translation>
    </message>
    <message>
        <source>min %1, max %2: nothing of it is on the target</source>
        <translation>最小值 %1，最大值 %2：没有一个在画面内</translation>
    </message>
    <message>
        <source>min %1, max %2, of which %3 to %4 are on the target</source>
        <translation>最小值 %1，最大值 %2，其中 %3 到 %4 在画面内</translation>
    </message>
    <message>
        <source>stored %1</source>
        <translation>存的是 %1</translation>
    </message>
    <message>
        <source>mean %1</source>
        <translation>平均 %1</translation>
    </message>
    <message>
        <source>%1 of %2 count as black, mean %3</source>
        <translation>%2 个中有 %1 个算作黑色，平均 %3</translation>
    </message>
    <message>
        <source>three edges, not yet told apart; heights %1</source>
        <translation>三条边，还没有区分；高度 %1</translation>
    </message>
    <message>
        <source>i %1, x %2, y %3</source>
        <translation>i %1，x %2，y %3</translation>
    </message>
    <message>
        <source>rounded to (%1, %2), error %3</source>
        <translation>取整到 (%1, %2)，误差 %3</translation>
    </message>
    <message>
        <source>x %1 -&gt; %2, y %3 -&gt; %4 in one column</source>
        <translation>x %1 -&gt; %2，y %3 -&gt; %4，只走一列</translation>
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
    <name>Unsupported</name>
    <message>
        <source>cull-space view needs object-space positions; this scene is given in clip space</source>
        <translation>按法线与视线判定朝向需要物体空间的位置；此场景由裁剪空间坐标给出</translation>
    </message>
    <message>
        <source>%1x%2 pixels with %3 samples each need more than %4 million samples</source>
        <translation>%1x%2 个像素、每像素 %3 个样本，合计超过 %4 百万个样本</translation>
    </message>
    <message>
        <source>there is no mistake &quot;%1&quot;; &quot;rasterlens-cli render --list-mistakes&quot; lists those there are</source>
        <translation>没有名为“%1”的错误；用“rasterlens-cli render --list-mistakes”可列出全部错误</translation>
    </message>
    <message>
        <source>algorithm tiled needs number-type fixed</source>
        <translation>分块算法只能用定点数</translation>
    </message>
    <message>
        <source>algorithm tiled needs fill solid</source>
        <translation>分块算法只能画实心填充</translation>
    </message>
    <message>
        <source>algorithm tiled needs visibility z-buffer or submission-order</source>
        <translation>分块算法的可见性只能用深度缓冲或提交顺序</translation>
    </message>
    <message>
        <source>algorithm tiled needs tie-rule top-left</source>
        <translation>分块算法的边界归属只能用左上规则</translation>
    </message>
    <message>
        <source>attribute-path edge-then-span needs algorithm edge-walking</source>
        <translation>属性先沿边再沿段插值，只能用边步进算法</translation>
    </message>
    <message>
        <source>algorithm tiled makes no mistakes; edge-equation and edge-walking do</source>
        <translation>分块算法不演示错误；边方程和边步进算法可以</translation>
    </message>
    <message>
        <source>this machine does not have simd %1</source>
        <translation>这台计算机没有向量指令 %1</translation>
    </message>
    <message>
        <source>algorithm tiled does not draw these settings</source>
        <translation>分块算法不能绘制这些设置</translation>
    </message>
    <message>
        <source>algorithm tiled computes no mip level by itself: it does not draw shading mip-level</source>
        <translation>tiled 算法不单独计算 mip 级别：它不画 mip-level 着色</translation>
    </message>
    <message>
        <source>samples msaa2 to msaa16 need fill solid: lines and points go from sample to sample of a grid, and a pattern has none</source>
        <translation>samples msaa2 到 msaa16 需要 fill solid：线和点是在网格的采样点之间走的，而采样图案没有网格</translation>
    </message>
    <message>
        <source>samples msaa2 to msaa16 need an algorithm that goes by centres; column-fill goes by the grid points of the corners</source>
        <translation>samples msaa2 到 msaa16 需要按中心判断的算法；column-fill 按顶点所在的网格点来画</translation>
    </message>
    <message>
        <source>samples msaa2 to msaa16 need attribute-path planes: a pixel is shaded once, and no span leads there</source>
        <translation>samples msaa2 到 msaa16 需要 attribute-path planes：一个像素只着色一次，没有扫描段通到那里</translation>
    </message>
    <message>
        <source>samples msaa2 to msaa16 do not go with a mistake about where samples are stored</source>
        <translation>samples msaa2 到 msaa16 不能与采样点存放位置方面的错误同时使用</translation>
    </message>
    <message>
        <source>algorithm tiled with several samples a pixel needs resolve gamma</source>
        <translation>分块算法在每个像素有多个采样点时，只能按显示值求平均</translation>
    </message>
    <message>
        <source>coverage-rule conservative and inner ask the corners of every pixel: they need algorithm edge-equation and fill solid</source>
        <translation>coverage-rule 为 conservative 或 inner 时要查每个像素的角点：需要 algorithm edge-equation 和 fill solid</translation>
    </message>
    <message>
        <source>coverage-rule conservative and inner need number-type fixed and corners that snap: rounding may not touch a square</source>
        <translation>coverage-rule 为 conservative 或 inner 时需要 number-type fixed 且顶点对齐到亚像素网格：舍入不得触及方格</translation>
    </message>
    <message>
        <source>coverage-rule conservative and inner are about whole pixels: they need samples 1</source>
        <translation>coverage-rule 为 conservative 或 inner 时针对整个像素：需要 samples 1</translation>
    </message>
    <message>
        <source>algorithm tiled keeps no counts of the samples of a grid; it does of one sample a pixel, and of msaa2 to msaa16</source>
        <translation>分块算法不保留网格中各采样点的计数；每个像素一个采样点时，以及 msaa2 到 msaa16 时保留</translation>
    </message>
    <message>
        <source>algorithm tiled with samples msaa2 to msaa16 needs attribute-at centre: it shades what is left when all triangles are drawn, and knows their masks no more</source>
        <translation>分块算法使用 msaa2 到 msaa16 时需要 attribute-at centre：它在所有三角形画完之后才给剩下的部分着色，那时已不知道各三角形的覆盖掩码</translation>
    </message>
    <message>
        <source>a turntable turns the camera; this scene is given in clip space and has none</source>
        <translation>转台让相机旋转；此场景由裁剪空间坐标给出，没有相机</translation>
    </message>
    <message>
        <source>algorithm tiled draws triangles, and this scene has lines; edge-equation, edge-walking and column-fill draw both</source>
        <translation>分块算法只画三角形，而这个场景里有线；边函数、边遍历和逐列填充两者都画</translation>
    </message>
    <message>
        <source>samples msaa2 to msaa16 do not go with the lines of this scene: lines go from sample to sample of a grid, and a pattern has none</source>
        <translation>msaa2 到 msaa16 不能用于这个场景里的线：线从网格的一个采样走到另一个采样，而采样图案没有网格</translation>
    </message>
    <message>
        <source>clipping cohen-sutherland here joins the outlines of faces, and this scene has lines; clipping frustum and guard-band cut them</source>
        <translation>这里的 Cohen-Sutherland 裁剪会把面的轮廓连接起来，而这个场景里有线；视锥体裁剪和保护带裁剪可以裁剪它们</translation>
    </message>
    <message>
        <source>interpolation every-8 and every-16 divide along spans: they need algorithm edge-walking, fill solid and attribute-path edge-then-span</source>
        <translation>interpolation every-8 与 every-16 沿扫描段做除法：需要 algorithm edge-walking、fill solid 与 attribute-path edge-then-span</translation>
    </message>
    <message>
        <source>OpenGL is asked for filled faces only</source>
        <translation>这里只让 OpenGL 绘制填充的面</translation>
    </message>
    <message>
        <source>OpenGL is asked for shading gouraud and texture only</source>
        <translation>这里只让 OpenGL 用 shading gouraud 与 texture</translation>
    </message>
    <message>
        <source>OpenGL is asked for one sample a pixel, at its centre</source>
        <translation>这里只让 OpenGL 每像素取一个样本，位于像素中心</translation>
    </message>
    <message>
        <source>OpenGL does not sort faces: it needs visibility z-buffer</source>
        <translation>OpenGL 不对面排序：需要 visibility z-buffer</translation>
    </message>
    <message>
        <source>OpenGL clips by the view volume: it needs clipping frustum</source>
        <translation>OpenGL 按视体裁剪：需要 clipping frustum</translation>
    </message>
    <message>
        <source>OpenGL clips at z = -w: it needs clip-z gl</source>
        <translation>OpenGL 在 z = -w 处裁剪：需要 clip-z gl</translation>
    </message>
    <message>
        <source>OpenGL is asked for one pass, without depth bias and range</source>
        <translation>这里只让 OpenGL 画一遍，不带深度偏移与深度范围</translation>
    </message>
    <message>
        <source>OpenGL has no depth-format unorm8</source>
        <translation>OpenGL 没有 depth-format unorm8</translation>
    </message>
    <message>
        <source>OpenGL is not told of masks: it needs alpha-test off</source>
        <translation>没有把遮罩告诉 OpenGL：需要 alpha-test off</translation>
    </message>
    <message>
        <source>OpenGL makes none of these mistakes</source>
        <translation>OpenGL 不会犯这些错误</translation>
    </message>
    <message>
        <source>this OpenGL draws at most %1 pixels a side</source>
        <translation>这个 OpenGL 每边最多画 %1 个像素</translation>
    </message>
</context>
<context>
    <name>rasterlens::ActionSearch</name>
    <message>
        <source>Search for an action, in English or Chinese</source>
        <translation>搜索操作，中英文均可</translation>
    </message>
</context>
<context>
    <name>rasterlens::ActionTable</name>
    <message>
        <source>File</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>编辑</translation>
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
        <source>Camera</source>
        <translation>摄像机</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>窗口</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>步骤</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>比较</translation>
    </message>
    <message>
        <source>Panels</source>
        <translation>面板</translation>
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
        <source>section</source>
        <translation>分组</translation>
    </message>
    <message>
        <source>key</source>
        <translation>按键</translation>
    </message>
    <message>
        <source>what</source>
        <translation>作用</translation>
    </message>
    <message>
        <source>Lessons</source>
        <translation>课程</translation>
    </message>
</context>
<context>
    <name>rasterlens::BarycentricLayer</name>
    <message>
        <source>perspective %1</source>
        <translation>透视 %1</translation>
    </message>
</context>
<context>
    <name>rasterlens::CanvasViews</name>
    <message>
        <source>Colour</source>
        <translation>颜色</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>深度</translation>
    </message>
    <message>
        <source>Ids</source>
        <translation>面编号</translation>
    </message>
    <message>
        <source>Overdraw</source>
        <translation>重绘次数</translation>
    </message>
    <message>
        <source>Facing</source>
        <translation>朝向</translation>
    </message>
    <message>
        <source>Normals</source>
        <translation>法线</translation>
    </message>
    <message>
        <source>UV</source>
        <translation>UV</translation>
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
        <source>Samples</source>
        <translation>采样点</translation>
    </message>
    <message>
        <source>Pixel values (from 48×)</source>
        <translation>像素数值（48× 起）</translation>
    </message>
    <message>
        <source>Wireframe over the picture</source>
        <translation>叠加在画面上的线框</translation>
    </message>
    <message>
        <source>Wireframe</source>
        <translation>线框</translation>
    </message>
    <message>
        <source>Outline of the face at the selected pixel</source>
        <translation>所选像素所属面的轮廓</translation>
    </message>
    <message>
        <source>Bounding boxes</source>
        <translation>包围盒</translation>
    </message>
    <message>
        <source>Boxes</source>
        <translation>包围盒</translation>
    </message>
    <message>
        <source>Tiles of the tiled algorithm</source>
        <translation>分块算法的块</translation>
    </message>
    <message>
        <source>Tiles</source>
        <translation>分块</translation>
    </message>
    <message>
        <source>Barycentric areas and iso-lines</source>
        <translation>重心坐标的面积与等值线</translation>
    </message>
    <message>
        <source>Barycentric</source>
        <translation>重心坐标</translation>
    </message>
    <message>
        <source>Mid-line, where α is nearly one half</source>
        <translation>中线：α 接近一半之处</translation>
    </message>
    <message>
        <source>Depth buffer beside the picture</source>
        <translation>画面旁的深度缓冲</translation>
    </message>
    <message>
        <source>The overlays were not computed: %1.</source>
        <translation>未能计算叠加内容：%1。</translation>
    </message>
    <message>
        <source>The view stays: %1</source>
        <translation>视图保持不变：%1</translation>
    </message>
    <message>
        <source>Views</source>
        <translation>视图</translation>
    </message>
    <message>
        <source>Overlays</source>
        <translation>叠加</translation>
    </message>
    <message>
        <source>Footprint of the selected pixel in the texture</source>
        <translation>所选像素在纹理中的足迹</translation>
    </message>
</context>
<context>
    <name>rasterlens::Cards</name>
    <message>
        <source>Vertices</source>
        <translation>顶点</translation>
    </message>
    <message>
        <source>Clip theatre</source>
        <translation>裁剪剧场</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>曲线</translation>
    </message>
    <message>
        <source>Algorithm race</source>
        <translation>算法竞赛</translation>
    </message>
    <message>
        <source>Copy as text</source>
        <translation>复制为文本</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>复制</translation>
    </message>
    <message>
        <source>The pixel card was not computed: %1.</source>
        <translation>像素卡未能算出：%1。</translation>
    </message>
    <message>
        <source>The face&apos;s panels were not computed: %1.</source>
        <translation>此面的面板未能算出：%1。</translation>
    </message>
    <message>
        <source>Derivations</source>
        <translation>推导</translation>
    </message>
    <message>
        <source>The derivation was not computed: %1.</source>
        <translation>没有算出推导：%1。</translation>
    </message>
    <message>
        <source>Pixel card: why this pixel?</source>
        <translation>像素卡：为什么是这个像素？</translation>
    </message>
</context>
<context>
    <name>rasterlens::CaseBrowser</name>
    <message>
        <source>A click opens a case in the lens, with its wrong pixels glowing; a click on a sign opens it with that variant.</source>
        <translation>点击案例即在透镜中打开，错误像素会发光；点击某个符号则以该变体打开。</translation>
    </message>
    <message>
        <source>What must hold:</source>
        <translation>必须成立：</translation>
    </message>
    <message>
        <source>%1 of %2 drawn, in %3 a variant fails</source>
        <translation>已画 %1/%2，其中 %3 个有变体失败</translation>
    </message>
    <message>
        <source>%1 of %2 cases listed, in %3 a variant fails</source>
        <translation>列出 %1/%2 个案例，%3 个有变体失败</translation>
    </message>
    <message>
        <source>Filter by name, note or expectation</source>
        <translation>按名称、说明或期望筛选</translation>
    </message>
    <message>
        <source>Only where a variant fails</source>
        <translation>只看有变体失败的</translation>
    </message>
    <message>
        <source>✓ passes, ≈ passes within what snapping or the depth format can tell, ✗ fails, – cannot be drawn</source>
        <translation>✓ 通过，≈ 在对齐或深度格式所能分辨的范围内通过，✗ 失败，– 无法绘制</translation>
    </message>
    <message>
        <source>Hard cases</source>
        <translation>疑难案例</translation>
    </message>
</context>
<context>
    <name>rasterlens::CaseModel</name>
    <message>
        <source>The hard cases were not drawn: %1.</source>
        <translation>疑难案例未能绘制：%1。</translation>
    </message>
</context>
<context>
    <name>rasterlens::ClipTheatre</name>
    <message>
        <source>clip space: %1 across, w up</source>
        <translation>裁剪空间：横轴 %1，纵轴 w</translation>
    </message>
    <message>
        <source>the nine regions: above, below, right, left</source>
        <translation>九个区域：上、下、右、左</translation>
    </message>
    <message>
        <source>the screen after the divide, and the fan</source>
        <translation>除法之后的屏幕与三角扇</translation>
    </message>
    <message>
        <source>no face</source>
        <translation>没有面</translation>
    </message>
    <message>
        <source>a corner is not a finite number</source>
        <translation>有顶点不是有限数</translation>
    </message>
    <message>
        <source>rejected whole: no plane had to cut</source>
        <translation>整体丢弃：无需切割</translation>
    </message>
    <message>
        <source>wholly inside: no plane cuts</source>
        <translation>全部在内：没有平面切割</translation>
    </message>
    <message>
        <source>kept whole: no plane of the mode cuts</source>
        <translation>整体保留：此模式没有平面切割</translation>
    </message>
    <message>
        <source>%1 corners: nothing is left</source>
        <translation>%1 个顶点：什么也没剩下</translation>
    </message>
    <message>
        <source>%1 corners, a fan of %2</source>
        <translation>%1 个顶点，扇形共 %2 个三角形</translation>
    </message>
    <message>
        <source>%1  outcode %2</source>
        <translation>%1  区域编码 %2</translation>
    </message>
    <message>
        <source>all corners are inside: nothing to cut here</source>
        <translation>所有顶点都在内：这里不用切</translation>
    </message>
    <message>
        <source>Plane %1: %2 corners before, %3 after</source>
        <translation>平面 %1：之前 %2 个顶点，之后 %3 个</translation>
    </message>
    <message>
        <source>Plane %1 does not cut this face</source>
        <translation>平面 %1 不切这个面</translation>
    </message>
    <message>
        <source>before</source>
        <translation>裁剪前</translation>
    </message>
    <message>
        <source>The triangle before any plane</source>
        <translation>任何平面之前的三角形</translation>
    </message>
    <message>
        <source>sides</source>
        <translation>四边</translation>
    </message>
    <message>
        <source>The four sides of the screen, edge by edge</source>
        <translation>屏幕的四条边，逐边裁剪</translation>
    </message>
    <message>
        <source>The coordinate that is drawn against w</source>
        <translation>与 w 对画的坐标</translation>
    </message>
    <message>
        <source>%1 corners</source>
        <translation>%1 个顶点</translation>
    </message>
    <message>
        <source>Plane %1: its turn comes later; a click shows it</source>
        <translation>平面 %1：还没轮到；点击即可查看</translation>
    </message>
</context>
<context>
    <name>rasterlens::CompareBar</name>
    <message>
        <source>A and B have the same settings: change one, or pin A and go on</source>
        <translation>A 与 B 的设置相同：改动一项，或固定 A 后继续</translation>
    </message>
    <message>
        <source>no mistakes</source>
        <translation>没有错误</translation>
    </message>
    <message>
        <source>scene&apos;s own</source>
        <translation>场景设定</translation>
    </message>
    <message>
        <source>pinned</source>
        <translation>已固定</translation>
    </message>
    <message>
        <source>Picture A</source>
        <translation>画面 A</translation>
    </message>
    <message>
        <source>Picture A; B is always the present one</source>
        <translation>画面 A；B 始终是当前画面</translation>
    </message>
    <message>
        <source>Pin</source>
        <translation>固定</translation>
    </message>
    <message>
        <source>Keep the present settings as A (A)</source>
        <translation>把当前设置固定为 A（A）</translation>
    </message>
    <message>
        <source>Exchange A and B (Shift+A)</source>
        <translation>交换 A 与 B（Shift+A）</translation>
    </message>
    <message>
        <source>Wipe</source>
        <translation>卷帘对比</translation>
    </message>
    <message>
        <source>A left of the line, B right of it; drag the line (S)</source>
        <translation>线左为 A，线右为 B；可拖动这条线（S）</translation>
    </message>
    <message>
        <source>Blink</source>
        <translation>闪烁</translation>
    </message>
    <message>
        <source>A and B in turn (B)</source>
        <translation>A 与 B 轮流显示（B）</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>差异</translation>
    </message>
    <message>
        <source>Where A and B differ, and how much (D)</source>
        <translation>A 与 B 何处不同、相差多少（D）</translation>
    </message>
    <message>
        <source>Stop comparing</source>
        <translation>结束比较</translation>
    </message>
    <message>
        <source>Amplification</source>
        <translation>放大倍数</translation>
    </message>
    <message>
        <source>Differences are multiplied by this before they are coloured</source>
        <translation>差异先乘以此数再上色</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>%1 more</source>
        <translation>另有 %1 项</translation>
    </message>
</context>
<context>
    <name>rasterlens::Comparison</name>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>A cannot be drawn: %1</source>
        <translation>无法绘制 A：%1</translation>
    </message>
    <message>
        <source>There is not enough memory for another picture of this size.</source>
        <translation>内存不足，无法再画一幅这样大小的画面。</translation>
    </message>
    <message>
        <source>drawing A …</source>
        <translation>正在绘制 A……</translation>
    </message>
    <message>
        <source>A and B are the same in all %1 pixels</source>
        <translation>A 与 B 的全部 %1 个像素都相同</translation>
    </message>
    <message>
        <source>%1 of %2 pixels differ, by at most %3 of 255 steps · PSNR %4 dB</source>
        <translation>%1 / %2 像素不同，最多 %3/255 级 · PSNR %4 dB</translation>
    </message>
    <message>
        <source>Mistakes</source>
        <translation>错误</translation>
    </message>
    <message>
        <source>A was not drawn: %1</source>
        <translation>A 未能绘制：%1</translation>
    </message>
    <message>
        <source>Towards the light</source>
        <translation>指向光源</translation>
    </message>
    <message>
        <source>%1 of %2 pixels differ</source>
        <translation>%1 / %2 像素不同</translation>
    </message>
</context>
<context>
    <name>rasterlens::CurvesPanel</name>
    <message>
        <source>The scene has no camera: near and far are examples.</source>
        <translation>场景没有相机：近、远平面是示例值。</translation>
    </message>
    <message>
        <source>An end of this edge is behind the eye: the numbers of the textbook are shown.</source>
        <translation>这条边有一端在眼睛后面：显示教科书中的数字。</translation>
    </message>
    <message>
        <source>Perspective correction n(m)</source>
        <translation>透视校正 n(m)</translation>
    </message>
    <message>
        <source>m, on the screen</source>
        <translation>m，屏幕上</translation>
    </message>
    <message>
        <source>n, in space</source>
        <translation>n，空间中</translation>
    </message>
    <message>
        <source>affine</source>
        <translation>仿射</translation>
    </message>
    <message>
        <source>z&apos; = n + f − nf / z</source>
        <translation>z&apos; = n + f − nf / z</translation>
    </message>
    <message>
        <source>z, distance</source>
        <translation>z，距离</translation>
    </message>
    <message>
        <source>z&apos;</source>
        <translation>z&apos;</translation>
    </message>
    <message>
        <source>z&apos; = z</source>
        <translation>z&apos; = z</translation>
    </message>
    <message>
        <source>Four-z board</source>
        <translation>四 z 对照表</translation>
    </message>
    <message>
        <source>NDC z</source>
        <translation>NDC z</translation>
    </message>
    <message>
        <source>distance z</source>
        <translation>距离 z</translation>
    </message>
    <message>
        <source>truth</source>
        <translation>真值</translation>
    </message>
    <message>
        <source>linear</source>
        <translation>线性</translation>
    </message>
    <message>
        <source>  error</source>
        <translation>  误差</translation>
    </message>
    <message>
        <source>&quot;corrected&quot;</source>
        <translation>“校正”</translation>
    </message>
    <message>
        <source>Edge AB</source>
        <translation>边 AB</translation>
    </message>
    <message>
        <source>Edge BC</source>
        <translation>边 BC</translation>
    </message>
    <message>
        <source>Edge CA</source>
        <translation>边 CA</translation>
    </message>
    <message>
        <source>Edge</source>
        <translation>边</translation>
    </message>
    <message>
        <source>Fraction of the way on the screen</source>
        <translation>屏幕上走过的比例</translation>
    </message>
    <message>
        <source>Textbook: n .1, f 50, z 1..10</source>
        <translation>教科书：n .1, f 50, z 1..10</translation>
    </message>
    <message>
        <source>The camera is orthographic: w is 1, n is m, and z&apos; is linear in the distance. The numbers of the textbook are shown.</source>
        <translation>相机是正交的：w 为 1，n 就是 m，z&apos; 随距离线性变化。这里显示教科书中的数。</translation>
    </message>
</context>
<context>
    <name>rasterlens::DepthPicture</name>
    <message>
        <source>Depth buffer: not known</source>
        <translation>深度缓冲：尚未知</translation>
    </message>
    <message>
        <source>Depth buffer: black %1, white %2</source>
        <translation>深度缓冲：黑 %1，白 %2</translation>
    </message>
</context>
<context>
    <name>rasterlens::DerivationPanel</name>
    <message>
        <source>Derivation</source>
        <translation>推导</translation>
    </message>
    <message>
        <source>Edge</source>
        <translation>边</translation>
    </message>
    <message>
        <source>Edge AB</source>
        <translation>边 AB</translation>
    </message>
    <message>
        <source>Edge BC</source>
        <translation>边 BC</translation>
    </message>
    <message>
        <source>Edge CA</source>
        <translation>边 CA</translation>
    </message>
    <message>
        <source>Part of the way along the edge</source>
        <translation>沿边走过的比例</translation>
    </message>
    <message>
        <source>Part of the way from near to far</source>
        <translation>从近平面到远平面的比例</translation>
    </message>
</context>
<context>
    <name>rasterlens::Dock</name>
    <message>
        <source>Close this panel; the menu Panels opens it again</source>
        <translation>关闭此面板；可从“面板”菜单重新打开</translation>
    </message>
</context>
<context>
    <name>rasterlens::ExperimentModel</name>
    <message>
        <source>Variant</source>
        <translation>变体</translation>
    </message>
    <message>
        <source>Mtri/s</source>
        <translation>百万三角形/秒</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>误差</translation>
    </message>
    <message>
        <source>%1: median; a row&apos;s tool-tip adds the tenth and ninetieth percentile</source>
        <translation>%1：中位数；行的提示中另有第 10 与第 90 百分位</translation>
    </message>
    <message>
        <source>ns/px</source>
        <translation>ns/像素</translation>
    </message>
    <message>
        <source>On the frontier: no variant with as small an error was faster in nine of ten rounds</source>
        <translation>在前沿上：误差不更大的变体中，没有一个在十轮里有九轮更快</translation>
    </message>
    <message>
        <source>How many times as long as the first variant in the same round: median of the pairs; a row&apos;s tool-tip adds the tenth and ninetieth percentile</source>
        <translation>同一轮中用时是第一个变体的多少倍：成对比值的中位数；行的提示中另有第 10 与第 90 百分位</translation>
    </message>
    <message>
        <source>Milliseconds of processor time, of all threads that work on a frame: median</source>
        <translation>处理器时间（毫秒），含参与一帧的所有线程：中位数</translation>
    </message>
    <message>
        <source>Ratio</source>
        <translation>比值</translation>
    </message>
    <message>
        <source>CPU ms</source>
        <translation>CPU 毫秒</translation>
    </message>
    <message>
        <source>tie rule: top-left</source>
        <translation>边上归属：左上规则</translation>
    </message>
    <message>
        <source>tie rule: top-right</source>
        <translation>边上归属：右上</translation>
    </message>
    <message>
        <source>tie rule: bottom-left</source>
        <translation>边上归属：左下</translation>
    </message>
    <message>
        <source>tie rule: bottom-right</source>
        <translation>边上归属：右下</translation>
    </message>
    <message>
        <source>tie rule: all edges own their points</source>
        <translation>边上归属：所有边都拥有其上的点</translation>
    </message>
    <message>
        <source>tie rule: no edge owns its points</source>
        <translation>边上归属：没有边拥有其上的点</translation>
    </message>
    <message>
        <source>tie rule: none that is known</source>
        <translation>边上归属：不是已知的规则</translation>
    </message>
    <message>
        <source>corners snap to 1/%1 pixel</source>
        <translation>顶点对齐到 1/%1 像素</translation>
    </message>
    <message>
        <source>corners snap to 1/%1 pixel or finer</source>
        <translation>顶点对齐到 1/%1 像素或更细</translation>
    </message>
    <message>
        <source>milliseconds of the clock: %1</source>
        <translation>时钟时间（毫秒）：%1</translation>
    </message>
    <message>
        <source>milliseconds of the processor, all threads: %1</source>
        <translation>处理器时间（毫秒，所有线程）：%1</translation>
    </message>
    <message>
        <source>times as long as the first variant: %1, in %2 pairs of frames</source>
        <translation>用时为第一个变体的倍数：%1，共 %2 对帧</translation>
    </message>
    <message>
        <source>timed in batches of %1 frames</source>
        <translation>每 %1 帧一批计时</translation>
    </message>
</context>
<context>
    <name>rasterlens::ExperimentPanel</name>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>测量</translation>
    </message>
    <message>
        <source>Every variant of the pipeline on the present scene: how fast, and how far from the exact picture.</source>
        <translation>在当前场景上测量管线的每个变体：有多快，离精确画面有多远。</translation>
    </message>
    <message>
        <source>Loaded: %1</source>
        <translation>已载入：%1</translation>
    </message>
    <message>
        <source>Export the measurements</source>
        <translation>导出测量结果</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>已写入：%1</translation>
    </message>
    <message>
        <source>frames each</source>
        <translation>帧/变体</translation>
    </message>
    <message>
        <source>Frames of each variant that count; one more warms up</source>
        <translation>每个变体计入的帧数；另有一帧预热</translation>
    </message>
    <message>
        <source>Error: coverage</source>
        <translation>误差：覆盖</translation>
    </message>
    <message>
        <source>Error: depth</source>
        <translation>误差：深度</translation>
    </message>
    <message>
        <source>Error: colour</source>
        <translation>误差：颜色</translation>
    </message>
    <message>
        <source>Error of the horizontal axis</source>
        <translation>横轴的误差</translation>
    </message>
    <message>
        <source>ns per pixel</source>
        <translation>纳秒/像素</translation>
    </message>
    <message>
        <source>Mtri/s</source>
        <translation>百万三角形/秒</translation>
    </message>
    <message>
        <source>Speed of the vertical axis</source>
        <translation>纵轴的速度</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>导出</translation>
    </message>
    <message>
        <source>Double-click or Enter loads the variant</source>
        <translation>双击或按回车载入该变体</translation>
    </message>
    <message>
        <source>There is not enough memory for a picture of this size.</source>
        <translation>内存不足，无法绘制这么大的图像。</translation>
    </message>
    <message>
        <source>The system does not start so many threads.</source>
        <translation>系统无法启动这么多线程。</translation>
    </message>
    <message>
        <source>%1 · no variant has this error here: colours need Gouraud or texture shading, depths a depth test</source>
        <translation>%1 · 这里没有变体具有这种误差：颜色需要 Gouraud 或纹理着色，深度需要深度测试</translation>
    </message>
    <message>
        <source>No other renderer: %1</source>
        <translation>没有其他渲染器：%1</translation>
    </message>
    <message>
        <source>%1 is another program: there is nothing to load</source>
        <translation>%1 是别的程序：没有可载入的设置</translation>
    </message>
    <message>
        <source>Other renderers</source>
        <translation>其他渲染器</translation>
    </message>
    <message>
        <source>Measures what draws by OpenGL on this machine as well: Mesa&apos;s software renderer, and graphics processors. The exact reference judges them as it judges ours.</source>
        <translation>同时测量这台机器上用 OpenGL 绘图的渲染器：Mesa 的软件渲染器和图形处理器。精确基准以同样的标准评判它们。</translation>
    </message>
    <message>
        <source>%1 · edge equation takes %2 times as long as edge walking (%3 to %4); a blog measured 1.36 or more</source>
        <translation>%1 · 边方程用时是边步进的 %2 倍（%3 至 %4）；一篇博客测得 1.36 倍或更多</translation>
    </message>
    <message>
        <source>Frames vary by %1 %; times that overlap are not ranked.</source>
        <translation>各帧相差 %1 %；时间范围重叠的不分先后。</translation>
    </message>
    <message>
        <source>Frames vary by %1 %, those under %2 ms are timed in batches of up to %3; times that overlap are not ranked.</source>
        <translation>各帧相差 %1 %，不足 %2 毫秒的成批计时，每批最多 %3 帧；时间范围重叠的不分先后。</translation>
    </message>
    <message>
        <source>Ranges are the tenth and ninetieth percentile of pairs of frames, drawn one soon after the other. The blog, written for students: 72 frames in more than 8 s with edge equation, 71 in 5.8 s with edge walking; one model, one run, a debug build.</source>
        <translation>范围是先后紧接绘制的成对帧的第 10 与第 90 百分位。那篇写给学生的博客：边方程 72 帧用 8 秒多，边步进 71 帧用 5.8 秒；一个模型，测一次，调试版。</translation>
    </message>
</context>
<context>
    <name>rasterlens::FacePicker</name>
    <message>
        <source>Face</source>
        <translation>面</translation>
    </message>
    <message>
        <source>of %1</source>
        <translation>共 %1</translation>
    </message>
    <message>
        <source>Faces are the triangles, counted from 0. A click on a pixel chooses the face seen there; the line beside a face is that of the f statement in the OBJ file that it is a part of.</source>
        <translation>面就是三角形，从 0 开始编号。点击像素会选中那里看到的面；面旁边的行号是它所属的 f 语句在 OBJ 文件中的行。</translation>
    </message>
</context>
<context>
    <name>rasterlens::FacingLayer</name>
    <message>
        <source>front</source>
        <translation>正面</translation>
    </message>
    <message>
        <source>back</source>
        <translation>背面</translation>
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
    <name>rasterlens::GeometryLayer</name>
    <message>
        <source>perspective</source>
        <translation>透视</translation>
    </message>
    <message>
        <source>linear on the screen</source>
        <translation>屏幕上线性</translation>
    </message>
</context>
<context>
    <name>rasterlens::GuideWindow</name>
    <message>
        <source>Guide to RasterLens</source>
        <translation>RasterLens 指南</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>返回</translation>
    </message>
    <message>
        <source>Guide</source>
        <translation>指南</translation>
    </message>
</context>
<context>
    <name>rasterlens::LessonMode</name>
    <message>
        <source>The lesson was not checked: %1.</source>
        <translation>课程没有检查：%1。</translation>
    </message>
    <message>
        <source>Less&amp;ons</source>
        <translation>课程(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Next slide</source>
        <translation>下一页(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Previous slide</source>
        <translation>上一页(&amp;P)</translation>
    </message>
    <message>
        <source>Next, previous slide, also by a presenter&apos;s remote</source>
        <translation>下一页、上一页，翻页笔也可以</translation>
    </message>
    <message>
        <source>&amp;Back to the lesson</source>
        <translation>回到课程(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Mark the selected pixel as an answer</source>
        <translation>把所选像素标为答案(&amp;M)</translation>
    </message>
    <message>
        <source>With slides for a &amp;second look</source>
        <translation>包括进阶页(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Keep answers in a file (CSV, no names)…</source>
        <translation>把答案存入文件（CSV，不含姓名）(&amp;K)…</translation>
    </message>
    <message>
        <source>&amp;Close the lesson</source>
        <translation>关闭课程(&amp;C)</translation>
    </message>
    <message>
        <source>Lesson</source>
        <translation>课程</translation>
    </message>
    <message>
        <source>Keep answers in a file</source>
        <translation>把答案存入文件</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>表格 (*.csv)</translation>
    </message>
    <message>
        <source>Answers are kept in %1, without names.</source>
        <translation>答案存入 %1，不含姓名。</translation>
    </message>
    <message>
        <source>%1: the answers cannot be written: %2</source>
        <translation>%1：答案无法写入：%2</translation>
    </message>
</context>
<context>
    <name>rasterlens::LessonPanel</name>
    <message>
        <source>Try it yourself</source>
        <translation>自己试试</translation>
    </message>
    <message>
        <source>Change anything: settings, mistakes, corners, steps. The lesson waits.</source>
        <translation>什么都可以改：设置、错误、顶点、步骤。课程会等着。</translation>
    </message>
    <message>
        <source>Back to the lesson</source>
        <translation>回到课程</translation>
    </message>
    <message>
        <source>Choose a lesson in the menu Lessons.</source>
        <translation>请在“课程”菜单里选一课。</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>第 %1 页，共 %2 页</translation>
    </message>
    <message>
        <source>%1 of %2 right</source>
        <translation>答对 %1 / %2</translation>
    </message>
    <message>
        <source>This question has no answer here.</source>
        <translation>这个问题在这里没有答案。</translation>
    </message>
    <message>
        <source>The answer: %1</source>
        <translation>答案：%1</translation>
    </message>
    <message>
        <source>✓ Right: %1</source>
        <translation>✓ 对：%1</translation>
    </message>
    <message>
        <source>✗ %1 of %2 found, %3 too many</source>
        <translation>✗ %2 个里找到 %1 个，多点了 %3 个</translation>
    </message>
    <message>
        <source>✗ Not quite. The answer: %1</source>
        <translation>✗ 不对。答案：%1</translation>
    </message>
    <message>
        <source>The lesson ends here.</source>
        <translation>这一课到此结束。</translation>
    </message>
    <message>
        <source>%1 of %2 questions answered right.</source>
        <translation>%2 个问题答对 %1 个。</translation>
    </message>
    <message>
        <source>(second look) </source>
        <translation>（进阶）</translation>
    </message>
    <message>
        <source>Second look: %1</source>
        <translation>进阶：第 %1 页</translation>
    </message>
    <message>
        <source>A first course leaves these slides out. A click shows them, here and in all lessons; the menu Lessons leaves them out again.</source>
        <translation>第一遍上课时跳过这些页。点一下就在这一课和所有课程里显示；在“课程”菜单里可以再次跳过。</translation>
    </message>
    <message>
        <source>Right so far: three digits, please.</source>
        <translation>到这里都对，请给出三位有效数字。</translation>
    </message>
    <message>
        <source>One more try; ▶ shows the answer.</source>
        <translation>再试一次；按 ▶ 看答案。</translation>
    </message>
    <message>
        <source>One more try, or ▶.</source>
        <translation>再试一次，或按 ▶。</translation>
    </message>
    <message>
        <source>the pixels marked</source>
        <translation>标出的像素</translation>
    </message>
    <message>
        <source>✗ Not quite.</source>
        <translation>✗ 不太对。</translation>
    </message>
    <message>
        <source>▶ opens the next lesson: %1</source>
        <translation>▶ 打开下一课：%1</translation>
    </message>
    <message>
        <source>✓ Right: all %1 pixels</source>
        <translation>✓ 对：%1 个像素全部找到</translation>
    </message>
</context>
<context>
    <name>rasterlens::LessonPlayer</name>
    <message>
        <source>The answer was not computed: %1.</source>
        <translation>答案没有算出：%1。</translation>
    </message>
</context>
<context>
    <name>rasterlens::LifeCycle</name>
    <message>
        <source>Unsaved changes cannot be kept in case the program ends unexpectedly: %1</source>
        <translation>无法保留未保存的更改以防程序意外结束：%1</translation>
    </message>
    <message>
        <source>Save the changes to &quot;%1&quot;?</source>
        <translation>要保存对“%1”的更改吗？</translation>
    </message>
    <message>
        <source>Otherwise settings, camera and moved vertices are lost.</source>
        <translation>否则设置、相机和移动过的顶点会丢失。</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>保存(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>放弃(&amp;D)</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
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
        <source>The program ended before changes to &quot;%1&quot; were saved (%2).</source>
        <translation>对“%1”的更改尚未保存，程序就已结束（%2）。</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>恢复</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>放弃</translation>
    </message>
    <message>
        <source>Changed on the disk: %1</source>
        <translation>磁盘上已更改：%1</translation>
    </message>
    <message>
        <source>Reload (F5)</source>
        <translation>重新读取 (F5)</translation>
    </message>
    <message>
        <source>No longer on the disk: %1. The scene stays as it was read.</source>
        <translation>磁盘上已不存在：%1。场景保持读取时的样子。</translation>
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
        <source>%1 stays: %2</source>
        <translation>%1保持不变：%2</translation>
    </message>
    <message>
        <source>These settings cannot be drawn: %1</source>
        <translation>无法按这些设置绘制：%1</translation>
    </message>
    <message>
        <source>pixel (%1, %2)</source>
        <translation>像素 (%1, %2)</translation>
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
        <source>Copy the counters as CSV</source>
        <translation>把计数复制为 CSV</translation>
    </message>
    <message>
        <source>Copy the counters as JSON</source>
        <translation>把计数复制为 JSON</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>清除</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>滚轮</translation>
    </message>
    <message>
        <source>Middle drag, Shift + drag</source>
        <translation>中键拖动，Shift + 拖动</translation>
    </message>
    <message>
        <source>Click, arrows</source>
        <translation>单击，方向键</translation>
    </message>
    <message>
        <source>Double click</source>
        <translation>双击</translation>
    </message>
    <message>
        <source>Drag</source>
        <translation>拖动</translation>
    </message>
    <message>
        <source>Right drag, Ctrl + wheel</source>
        <translation>右键拖动，Ctrl + 滚轮</translation>
    </message>
    <message>
        <source>Ctrl + drag</source>
        <translation>Ctrl + 拖动</translation>
    </message>
    <message>
        <source>Menu View</source>
        <translation>“视图”菜单</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>打开</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>所有文件 (*)</translation>
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
        <source>&amp;Mistakes</source>
        <translation>错误(&amp;M)</translation>
    </message>
    <message>
        <source>List of mistakes</source>
        <translation>错误列表</translation>
    </message>
    <message>
        <source>Fast first picture (camera moves, slow scenes)</source>
        <translation>先快速出图（相机移动、绘制较慢时）</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>The name of the dropped file did not arrive. Open it from the menu.</source>
        <translation>拖入的文件名没有传到。请从菜单中打开它。</translation>
    </message>
    <message>
        <source>Re&amp;load from disk</source>
        <translation>从磁盘重新读取(&amp;L)</translation>
    </message>
    <message>
        <source>%1 (not found)</source>
        <translation>%1（未找到）</translation>
    </message>
    <message>
        <source>One file at a time: %1 is opened.</source>
        <translation>一次只能打开一个文件：已打开 %1。</translation>
    </message>
    <message>
        <source>Zoom at the cursor</source>
        <translation>以光标为中心缩放</translation>
    </message>
    <message>
        <source>Move the picture</source>
        <translation>移动画面</translation>
    </message>
    <message>
        <source>Choose a pixel, move on by one</source>
        <translation>选择像素，逐个移动</translation>
    </message>
    <message>
        <source>Close up of a pixel</source>
        <translation>放大到像素</translation>
    </message>
    <message>
        <source>Orbit</source>
        <translation>环绕</translation>
    </message>
    <message>
        <source>Nearer, farther</source>
        <translation>拉近、拉远</translation>
    </message>
    <message>
        <source>Move the scene</source>
        <translation>移动场景</translation>
    </message>
    <message>
        <source>From the front, the right, above</source>
        <translation>前、右、俯视图</translation>
    </message>
    <message>
        <source>&amp;Search for an action…</source>
        <translation>搜索操作(&amp;S)…</translation>
    </message>
    <message>
        <source>Leave field, help, presentation, steps</source>
        <translation>依次离开输入框、帮助、演示模式、单步</translation>
    </message>
    <message>
        <source>Tab, Shift + Tab</source>
        <translation>Tab，Shift + Tab</translation>
    </message>
    <message>
        <source>To the next field, back</source>
        <translation>到下一个输入框、返回</translation>
    </message>
    <message>
        <source>Clipping, next value</source>
        <translation>裁剪：下一个值</translation>
    </message>
    <message>
        <source>Culling, next value</source>
        <translation>面剔除：下一个值</translation>
    </message>
    <message>
        <source>Fill, next value</source>
        <translation>填充：下一个值</translation>
    </message>
    <message>
        <source>Depth test, next value</source>
        <translation>深度测试：下一个值</translation>
    </message>
    <message>
        <source>Interpolation, next value</source>
        <translation>插值：下一个值</translation>
    </message>
    <message>
        <source>Scenes, cases, sessions and lessons (*.obj *.case *.json)</source>
        <translation>场景、用例、会话和课程 (*.obj *.case *.json)</translation>
    </message>
    <message>
        <source>All menus: scenes, mistakes, panels, lessons</source>
        <translation>全部菜单：场景、错误、面板、课程</translation>
    </message>
    <message>
        <source>Every step of %1 x %2 pixels is recorded. In a small picture each step is seen.</source>
        <translation>%1 x %2 个像素的每一步都记录了。小图里每一步都看得清。</translation>
    </message>
    <message>
        <source>Draw at %1 x %2</source>
        <translation>改画 %1 x %2</translation>
    </message>
    <message>
        <source>Which &amp;mistake is mine?…</source>
        <translation>我犯的是哪个错误(&amp;M)？…</translation>
    </message>
    <message>
        <source>Export before and after…</source>
        <translation>导出错误前后对比…</translation>
    </message>
    <message>
        <source>Export before and after</source>
        <translation>导出错误前后对比</translation>
    </message>
    <message>
        <source>Export handout of a lesson…</source>
        <translation>导出课程讲义…</translation>
    </message>
    <message>
        <source>Export pa&amp;ge for browsers…</source>
        <translation>导出网页(&amp;G)…</translation>
    </message>
    <message>
        <source>&amp;Copy figure</source>
        <translation>复制插图(&amp;C)</translation>
    </message>
    <message>
        <source>Copy framebuffer 1:1</source>
        <translation>复制帧缓冲 1:1</translation>
    </message>
    <message>
        <source>With caption, formula and legend</source>
        <translation>带说明、公式和图例</translation>
    </message>
    <message>
        <source>Which mistake is mine?</source>
        <translation>我犯的是哪个错误？</translation>
    </message>
    <message>
        <source>Pictures and arrays (%1)</source>
        <translation>图片和数组 (%1)</translation>
    </message>
    <message>
        <source>Export a run as &amp;GIF…</source>
        <translation>导出一段步骤为 GIF(&amp;G)…</translation>
    </message>
    <message>
        <source>&amp;Guide</source>
        <translation>指南(&amp;G)</translation>
    </message>
    <message>
        <source>Export a run as GIF</source>
        <translation>导出一段步骤为 GIF</translation>
    </message>
    <message>
        <source>towards the light: %1</source>
        <translation>指向光源：%1</translation>
    </message>
    <message>
        <source>Nothing is copied: the picture is empty or too large.</source>
        <translation>没有复制：画面是空的，或者太大。</translation>
    </message>
    <message>
        <source>On the clipboard: a picture of %1 x %2 pixels.</source>
        <translation>已复制到剪贴板：%1 x %2 像素的图像。</translation>
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
    <name>rasterlens::MistakeBadge</name>
    <message>
        <source>hit twice</source>
        <translation>重复命中</translation>
    </message>
    <message>
        <source>covered</source>
        <translation>覆盖</translation>
    </message>
    <message>
        <source>tested</source>
        <translation>测试</translation>
    </message>
    <message>
        <source>depth passed</source>
        <translation>深度通过</translation>
    </message>
    <message>
        <source>depth failed</source>
        <translation>深度失败</translation>
    </message>
    <message>
        <source>rejected</source>
        <translation>丢弃</translation>
    </message>
    <message>
        <source>culled, back</source>
        <translation>剔除，背面</translation>
    </message>
    <message>
        <source>degenerate</source>
        <translation>退化</translation>
    </message>
    <message>
        <source>rasterized</source>
        <translation>已光栅化</translation>
    </message>
    <message>
        <source>holes</source>
        <translation>洞</translation>
    </message>
    <message>
        <source>stray pixels</source>
        <translation>多余像素</translation>
    </message>
    <message>
        <source>pixels of a wrong face</source>
        <translation>面错误的像素</translation>
    </message>
    <message>
        <source>wrong pixels</source>
        <translation>错误像素</translation>
    </message>
    <message>
        <source>depth error</source>
        <translation>深度误差</translation>
    </message>
    <message>
        <source>colours</source>
        <translation>颜色数</translation>
    </message>
    <message>
        <source>white pixels of light lost</source>
        <translation>丢失的亮度（白像素）</translation>
    </message>
    <message>
        <source>, right: %1</source>
        <translation>，正确值：%1</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>还有 %n 个</numerusform>
        </translation>
    </message>
    <message>
        <source>The mistakes were not counted: %1.</source>
        <translation>错误未能计数：%1。</translation>
    </message>
</context>
<context>
    <name>rasterlens::MistakesMenu</name>
    <message>
        <source>None</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Show in its scene</source>
        <translation>在它的场景中演示</translation>
    </message>
</context>
<context>
    <name>rasterlens::MistakesSection</name>
    <message>
        <source>The wrong line</source>
        <translation>错误的一行</translation>
    </message>
    <message>
        <source>What one sees</source>
        <translation>看到的现象</translation>
    </message>
    <message>
        <source>Why people write it</source>
        <translation>为什么会这样写</translation>
    </message>
    <message>
        <source>Mistakes: none</source>
        <translation>错误：无</translation>
    </message>
    <message>
        <source>Mistakes: %1</source>
        <translation>错误：%1</translation>
    </message>
    <message>
        <source>Mistakes that people make in a rasterizer, to switch on and look at</source>
        <translation>人们写光栅化器时常犯的错误，可以打开来看</translation>
    </message>
    <message>
        <source>none</source>
        <translation>全部关闭</translation>
    </message>
    <message>
        <source>Switch all mistakes off</source>
        <translation>关闭所有错误</translation>
    </message>
    <message>
        <source>show</source>
        <translation>演示</translation>
    </message>
    <message>
        <source>Show in its scene</source>
        <translation>在它的场景中演示</translation>
    </message>
    <message>
        <source>Show %1 in its scene</source>
        <translation>在它的场景中演示 %1</translation>
    </message>
</context>
<context>
    <name>rasterlens::NumberDial</name>
    <message>
        <source>1 unit = %1 px</source>
        <translation>1 单位 = %1 像素</translation>
    </message>
    <message>
        <source>step %1 px</source>
        <translation>步长 %1 像素</translation>
    </message>
    <message>
        <source>%1 of %2 bits, %3 left</source>
        <translation>用 %1/%2 位，余 %3 位</translation>
    </message>
    <message>
        <source>needs %1 bits, has %2</source>
        <translation>需 %1 位，只有 %2 位</translation>
    </message>
    <message>
        <source>float</source>
        <translation>浮点</translation>
    </message>
    <message>
        <source>fixed point, bits after the point</source>
        <translation>定点数，小数位数</translation>
    </message>
    <message>
        <source>Number dial: %1, %2</source>
        <translation>数值转盘：%1，%2</translation>
    </message>
    <message>
        <source>The numbers that decide which samples are inside. Up and Down turn the dial.</source>
        <translation>决定哪些样本在内部的数值。按上、下键转动转盘。</translation>
    </message>
    <message>
        <source>The bar shows the bits of the largest edge value on this picture: filled are those it needs; what does not fit into the number is rounded away, and samples close to an edge may be decided wrongly.</source>
        <translation>横条表示此画面上最大边函数值的位数：填色部分是它所需的位；放不下的位会被舍入，靠近边的样本就可能判错。</translation>
    </message>
</context>
<context>
    <name>rasterlens::PanelPlaces</name>
    <message>
        <source>Tabs &amp;below the canvas</source>
        <translation>面板放在画布下方(&amp;B)</translation>
    </message>
    <message>
        <source>Scene and pipeline</source>
        <translation>场景与管线</translation>
    </message>
    <message>
        <source>Statistics</source>
        <translation>统计</translation>
    </message>
    <message>
        <source>Pixel card: why this pixel?</source>
        <translation>像素卡：为什么是这个像素？</translation>
    </message>
    <message>
        <source>Vertices</source>
        <translation>顶点</translation>
    </message>
    <message>
        <source>Clip theatre</source>
        <translation>裁剪剧场</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>曲线</translation>
    </message>
    <message>
        <source>Algorithm race</source>
        <translation>算法竞赛</translation>
    </message>
    <message>
        <source>Hard cases</source>
        <translation>疑难案例</translation>
    </message>
    <message>
        <source>Speed against error</source>
        <translation>速度与误差</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>步骤</translation>
    </message>
    <message>
        <source>Derivations</source>
        <translation>推导</translation>
    </message>
    <message>
        <source>Lesson</source>
        <translation>课程</translation>
    </message>
    <message>
        <source>Which mistake is mine?</source>
        <translation>我犯的是哪个错误？</translation>
    </message>
    <message>
        <source>Charts of errors</source>
        <translation>误差图表</translation>
    </message>
</context>
<context>
    <name>rasterlens::PanelSpin</name>
    <message>
        <source>&quot;%1&quot; is not a whole number from %2 to %3</source>
        <translation>“%1”不是 %2 到 %3 之间的整数</translation>
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
    <message>
        <source>Where float32 fails</source>
        <translation>float32 在哪里出错</translation>
    </message>
    <message>
        <source>Opens a scene with float32 and has the referee check it</source>
        <translation>用 float32 打开一个场景，并用精确基准核对</translation>
    </message>
    <message>
        <source>No material of this scene has a texture: a checkerboard stands for it.</source>
        <translation>本场景没有一种材质带纹理：以棋盘格代替。</translation>
    </message>
    <message>
        <source>Lines run from the pixel of one corner to that of the next, up to half a pixel beside the edge. With the line rule &quot;Diamond exit&quot; the edge itself decides.</source>
        <translation>线从一个顶点所在的像素画到下一个顶点所在的像素，可能偏离边至多半个像素。线规则选“离开菱形”时由边本身决定。</translation>
    </message>
</context>
<context>
    <name>rasterlens::PixelCard</name>
    <message>
        <source>left edge</source>
        <translation>左边</translation>
    </message>
    <message>
        <source>top edge</source>
        <translation>上边</translation>
    </message>
    <message>
        <source>neither left nor top</source>
        <translation>既非左边也非上边</translation>
    </message>
    <message>
        <source>no plane</source>
        <translation>没有平面</translation>
    </message>
    <message>
        <source>dropped: a corner is not a finite number</source>
        <translation>丢弃：有顶点不是有限数</translation>
    </message>
    <message>
        <source>rejected by %1</source>
        <translation>被 %1 平面丢弃</translation>
    </message>
    <message>
        <source>culled: back face</source>
        <translation>剔除：背面</translation>
    </message>
    <message>
        <source>culled: front face</source>
        <translation>剔除：正面</translation>
    </message>
    <message>
        <source>no area on the screen</source>
        <translation>屏幕上没有面积</translation>
    </message>
    <message>
        <source>clipped away by %1</source>
        <translation>被 %1 平面裁掉</translation>
    </message>
    <message>
        <source>no corner of it is drawn here</source>
        <translation>它的顶点没有画在这里</translation>
    </message>
    <message>
        <source>no column of it is filled here</source>
        <translation>它没有哪一列填到这里</translation>
    </message>
    <message>
        <source>no line of it is drawn here</source>
        <translation>它的线没有画到这里</translation>
    </message>
    <message>
        <source>outside of what clipping left</source>
        <translation>在裁剪剩下的部分之外</translation>
    </message>
    <message>
        <source>%1, outside</source>
        <translation>%1，在外侧</translation>
    </message>
    <message>
        <source>%1, lost the tie: %2</source>
        <translation>%1，恰在边上，不归本面：%2</translation>
    </message>
    <message>
        <source>failed depth: not %1 %2 %3</source>
        <translation>深度失败：%1 %2 %3 不成立</translation>
    </message>
    <message>
        <source>covered, but not drawn by this algorithm</source>
        <translation>已覆盖，但此算法没有画</translation>
    </message>
    <message>
        <source>written, overwritten later by face %1</source>
        <translation>已写入，后来被面 %1 覆盖</translation>
    </message>
    <message>
        <source>written: what you see</source>
        <translation>已写入：就是所见</translation>
    </message>
    <message>
        <source>perspective %1</source>
        <translation>透视 %1</translation>
    </message>
    <message>
        <source>z %1 %2 %3, passed</source>
        <translation>z %1 %2 %3，通过</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>screen area</source>
        <translation>屏幕面积</translation>
    </message>
    <message>
        <source>won the tie on %1: %2</source>
        <translation>恰在边 %1 上，归本面：%2</translation>
    </message>
    <message>
        <source>%1 over %2</source>
        <translation>%1 覆盖 %2</translation>
    </message>
    <message>
        <source>Why pixel (%1, %2)?</source>
        <translation>像素 (%1, %2) 为什么？</translation>
    </message>
    <message>
        <source>Why this pixel?</source>
        <translation>为什么是这个像素？</translation>
    </message>
    <message>
        <source>face %1</source>
        <translation>面 %1</translation>
    </message>
    <message>
        <source>background: no face was written</source>
        <translation>背景：没有面写入</translation>
    </message>
    <message>
        <source>Show the step at which this was decided</source>
        <translation>显示作出决定的那一步</translation>
    </message>
    <message>
        <source>Click a pixel of the picture: here you see every face that could concern it, how far it got, and the numbers that decided.</source>
        <translation>点击画面上的一个像素：这里会列出所有可能与它有关的面、各走到了哪一步，以及起决定作用的数字。</translation>
    </message>
    <message>
        <source>No face comes near this pixel.</source>
        <translation>没有面靠近这个像素。</translation>
    </message>
    <message numerus="yes">
        <source>and %n more faces; Copy has them all</source>
        <translation>
            <numerusform>另有 %n 个面；“复制”可得到全部</numerusform>
        </translation>
    </message>
    <message>
        <source>cut out by the alpha test: the texture is opaque by %1</source>
        <translation>被 alpha 测试剪去：纹理的不透明度为 %1</translation>
    </message>
    <message>
        <source>face %1, line %2</source>
        <translation>面 %1，第 %2 行</translation>
    </message>
    <message>
        <source>%1 is seen</source>
        <translation>看到的是%1</translation>
    </message>
    <message>
        <source>its area on the screen, %1, counts as none</source>
        <translation>它在屏幕上的面积 %1 视为没有</translation>
    </message>
    <message>
        <source>%1, less than %2, outside</source>
        <translation>%1，小于 %2，在外</translation>
    </message>
    <message>
        <source>Its samples and their mean</source>
        <translation>它的采样点和它们的平均</translation>
    </message>
    <message>
        <source>Without %1</source>
        <translation>没有 %1 时</translation>
    </message>
    <message>
        <source>texel %1 of %2 x %3; right %4, down %5; mip level %6</source>
        <translation>纹素 %1，共 %2 x %3；向右 %4，向下 %5；mip 级别 %6</translation>
    </message>
    <message>
        <source>covers none of %1 samples</source>
        <translation>%1 个采样点一个也没有覆盖</translation>
    </message>
    <message>
        <source>covers %1 of %2 samples: %3</source>
        <translation>覆盖 %2 个采样点中的 %1 个：%3</translation>
    </message>
    <message>
        <source>%1, a part of the square is outside</source>
        <translation>%1，方格有一部分在外</translation>
    </message>
    <message>
        <source>%1, the whole square is outside</source>
        <translation>%1，整个方格都在外</translation>
    </message>
    <message>
        <source>%1 % of the pixel&apos;s area</source>
        <translation>占像素面积的 %1 %</translation>
    </message>
</context>
<context>
    <name>rasterlens::PlaneFields</name>
    <message>
        <source>&quot;%1&quot; is not a distance. Write a number greater than 0, or nothing.</source>
        <translation>&quot;%1&quot; 不是距离。请写一个大于 0 的数，或者留空。</translation>
    </message>
    <message>
        <source>auto (%1)</source>
        <translation>自动 (%1)</translation>
    </message>
    <message>
        <source>Near plane</source>
        <translation>近平面</translation>
    </message>
    <message>
        <source>Far plane</source>
        <translation>远平面</translation>
    </message>
    <message>
        <source>Distance from the eye. Leave it empty and the camera puts the plane round the scene.</source>
        <translation>到眼睛的距离。留空时相机按场景的大小放置平面。</translation>
    </message>
    <message>
        <source>Put back what the scene asks for</source>
        <translation>恢复场景要求的值</translation>
    </message>
</context>
<context>
    <name>rasterlens::QuestionBox</name>
    <message>
        <source>Click the pixels on the canvas.</source>
        <translation>请在画布上点像素。</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>清除</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>检查</translation>
    </message>
    <message>
        <source>your answer</source>
        <translation>你的答案</translation>
    </message>
    <message>
        <source>whole, or three digits</source>
        <translation>整数，或三位有效数字</translation>
    </message>
    <message>
        <source>Pixels marked: %1</source>
        <translation>已标 %1 个像素</translation>
    </message>
</context>
<context>
    <name>rasterlens::RacePanel</name>
    <message>
        <source>Edge walking</source>
        <translation>边步进</translation>
    </message>
    <message>
        <source>Edge equation</source>
        <translation>边方程</translation>
    </message>
    <message>
        <source>samples tested</source>
        <translation>测试样本</translation>
    </message>
    <message>
        <source>covered</source>
        <translation>覆盖</translation>
    </message>
    <message>
        <source>wasted</source>
        <translation>白费</translation>
    </message>
    <message>
        <source>additions</source>
        <translation>加法</translation>
    </message>
    <message>
        <source>multiplications</source>
        <translation>乘法</translation>
    </message>
    <message>
        <source>divisions</source>
        <translation>除法</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>暂停</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>播放</translation>
    </message>
    <message>
        <source>too many samples to race: choose a smaller picture</source>
        <translation>样本太多，无法竞赛：请选小一些的画面</translation>
    </message>
    <message>
        <source>this face is not drawn</source>
        <translation>这个面没有画</translation>
    </message>
    <message>
        <source>sample %1 of %2</source>
        <translation>样本 %1 / %2</translation>
    </message>
    <message>
        <source>To the start</source>
        <translation>回到开头</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>单步</translation>
    </message>
    <message>
        <source>One sample further, in both</source>
        <translation>两边各前进一个样本</translation>
    </message>
    <message>
        <source>Sample of the race</source>
        <translation>竞赛中的样本</translation>
    </message>
    <message>
        <source>Blue: covered. Orange: tested in vain. What one of the two alone chose blinks at the end.</source>
        <translation>蓝色：覆盖。橙色：白测了。只有一方选中的像素在结束时闪烁。</translation>
    </message>
</context>
<context>
    <name>rasterlens::ReadoutBar</name>
    <message>
        <source>pixel (%1, %2)</source>
        <translation>像素 (%1, %2)</translation>
    </message>
    <message>
        <source>face %1</source>
        <translation>面 %1</translation>
    </message>
    <message>
        <source>depth %1</source>
        <translation>深度 %1</translation>
    </message>
    <message>
        <source>background</source>
        <translation>背景</translation>
    </message>
    <message>
        <source>face %1, line %2</source>
        <translation>面 %1，第 %2 行</translation>
    </message>
</context>
<context>
    <name>rasterlens::Referee</name>
    <message>
        <source>not checked: these settings cannot be drawn</source>
        <translation>未核对：这些设置无法绘制</translation>
    </message>
    <message>
        <source>not checked: only filled triangles have a true coverage</source>
        <translation>未核对：只有填充的三角形才有真实覆盖</translation>
    </message>
    <message>
        <source>checking …</source>
        <translation>正在核对……</translation>
    </message>
    <message>
        <source>none wrong of %1 samples</source>
        <translation>%1 个样本全部正确</translation>
    </message>
    <message>
        <source>none wrong of %1 pixels, judged by their middle samples</source>
        <translation>%1 个像素全部正确（按中间的样本判定）</translation>
    </message>
    <message>
        <source>%1 of %2 samples</source>
        <translation>%1（共 %2 个样本）</translation>
    </message>
    <message>
        <source>%1 of %2 pixels, judged by their middle samples</source>
        <translation>%1（共 %2 个像素，按中间的样本判定）</translation>
    </message>
    <message>
        <source>depth off by at most %1</source>
        <translation>深度误差不超过 %1</translation>
    </message>
    <message>
        <source>colour by at most %1 of 255 steps</source>
        <translation>颜色误差不超过 %1 级（共 255 级）</translation>
    </message>
    <message>
        <source>%1 within %2 px of an edge let pass</source>
        <translation>距边 %2 像素以内的 %1 个放行</translation>
    </message>
    <message>
        <source>%1 right</source>
        <translation>正确 %1</translation>
    </message>
    <message>
        <source>%1 of another face</source>
        <translation>别的面 %1</translation>
    </message>
    <message>
        <source>%1 hit too seldom</source>
        <translation>命中过少 %1</translation>
    </message>
    <message>
        <source>%1 hit twice</source>
        <translation>重复命中 %1</translation>
    </message>
    <message>
        <source>%1 extra</source>
        <translation>多余 %1</translation>
    </message>
    <message>
        <source>%1 missing</source>
        <translation>缺失 %1</translation>
    </message>
    <message>
        <source>not checked: there is not enough memory for another picture of this size</source>
        <translation>未检查：内存不足以再存一幅这样大的画面</translation>
    </message>
    <message>
        <source>checking … %1 %</source>
        <translation>正在检查……%1 %</translation>
    </message>
    <message>
        <source>not checked: %1</source>
        <translation>未核对：%1</translation>
    </message>
</context>
<context>
    <name>rasterlens::RefereeBar</name>
    <message>
        <source>Referee</source>
        <translation>精确基准</translation>
    </message>
    <message>
        <source>Every sample against the exact reference: integers of any length, no rounding anywhere</source>
        <translation>每个样本都与精确参考对照：任意长整数，处处不舍入</translation>
    </message>
    <message>
        <source>Next ›</source>
        <translation>下一个 ›</translation>
    </message>
    <message>
        <source>Show the next wrong pixel (Shift+V)</source>
        <translation>显示下一个错误像素（Shift+V）</translation>
    </message>
    <message>
        <source>Send the referee off (V)</source>
        <translation>关闭精确基准（V）</translation>
    </message>
    <message>
        <source>from object space</source>
        <translation>从物体空间判起</translation>
    </message>
    <message>
        <source>from clip space</source>
        <translation>从裁剪空间判起</translation>
    </message>
    <message>
        <source>The corners of this scene are given in clip space: there is no vertex stage to judge</source>
        <translation>此场景的顶点直接以裁剪空间坐标给出：没有顶点阶段可判</translation>
    </message>
    <message>
        <source>The truth starts from the mesh and the camera: what float32 loses in the vertex stage counts as well. Click to take that stage&apos;s results as given (Ctrl+Shift+V)</source>
        <translation>真值从网格和相机算起：顶点阶段中 float32 损失的也算在内。点击则以该阶段的结果为准 (Ctrl+Shift+V)</translation>
    </message>
    <message>
        <source>The truth starts from the clip-space positions that the vertex stage has made: that stage itself is not judged. Click to judge it as well (Ctrl+Shift+V)</source>
        <translation>真值从顶点阶段算出的裁剪空间位置算起：该阶段本身不受评判。点击则一并评判 (Ctrl+Shift+V)</translation>
    </message>
</context>
<context>
    <name>rasterlens::RenderWorker</name>
    <message>
        <source>The system does not start so many threads.</source>
        <translation>系统无法启动这么多线程。</translation>
    </message>
    <message>
        <source>There is not enough memory for a picture of this size.</source>
        <translation>内存不足，无法绘制这么大的图像。</translation>
    </message>
    <message>
        <source>Pictures of %1 x %2 take up to %3 of memory. It is given back with the next smaller one.</source>
        <translation>%1 × %2 的图像最多占用 %3 内存，换成较小的图像后即归还。</translation>
    </message>
    <message>
        <source>There is not enough memory for a picture of this size: it takes %1, and %2 are free.</source>
        <translation>内存不足，无法绘制这么大的图像：需要 %1，可用 %2。</translation>
    </message>
</context>
<context>
    <name>rasterlens::RunAnimation</name>
    <message>
        <source>Drawing the steps…</source>
        <translation>正在绘制各步骤…</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Export a run as GIF</source>
        <translation>导出一段步骤为 GIF</translation>
    </message>
</context>
<context>
    <name>rasterlens::RunExport</name>
    <message>
        <source>Writing the pictures…</source>
        <translation>正在写入图片…</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Export a run of steps</source>
        <translation>导出一段步骤</translation>
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
        <source>not snapped</source>
        <translation>不对齐</translation>
    </message>
    <message>
        <source>no snap</source>
        <comment>short for not snapped</comment>
        <translation>不对齐</translation>
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
    <name>rasterlens::StatisticsPanel</name>
    <message>
        <source>%1 ms</source>
        <translation>%1 毫秒</translation>
    </message>
    <message>
        <source>vertex %1 · geometry %2 · raster %3</source>
        <translation>顶点 %1 · 几何 %2 · 光栅 %3</translation>
    </message>
    <message>
        <source>Time of the last frame.</source>
        <translation>最近一帧的时间。</translation>
    </message>
    <message>
        <source>Milliseconds of the last frame in each part of the pipeline.</source>
        <translation>最近一帧在流水线各部分所用的毫秒数。</translation>
    </message>
    <message>
        <source>FPS, tiled</source>
        <translation>FPS，分块算法</translation>
    </message>
    <message>
        <source>Frames per second: counted while frames keep coming, else what the last frame&apos;s time allows. While the camera moves, and first where pictures take long, the tiled algorithm draws the same picture.</source>
        <translation>每秒帧数：连续绘制时为实际计数，否则由最近一帧的时间推算。相机移动时，以及绘制较慢时的第一幅画面，由分块算法绘制，画面相同。</translation>
    </message>
    <message>
        <source>From a move to its picture on the screen: %1 ms, the median of %2.</source>
        <translation>从移动到画面显示：%1 毫秒（%2 次的中位数）。</translation>
    </message>
    <message>
        <source>%1 ms a frame</source>
        <translation>每帧 %1 ms</translation>
    </message>
    <message>
        <source>%1 FPS</source>
        <translation>%1 FPS</translation>
    </message>
    <message>
        <source>clipped %1 · culled: back %2, front %3</source>
        <translation>裁剪 %1 · 剔除：背面 %2，正面 %3</translation>
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
    <message>
        <source>The record has no step &quot;%1&quot;: this is its end.</source>
        <translation>记录中没有步骤“%1”：这里是记录的末尾。</translation>
    </message>
    <message>
        <source>The record holds no step of face %1.</source>
        <translation>记录中没有面 %1 的步骤。</translation>
    </message>
</context>
<context>
    <name>rasterlens::StepSession</name>
    <message>
        <source>There is not enough memory to record this frame.</source>
        <translation>内存不足，无法记录这一帧。</translation>
    </message>
    <message>
        <source>This frame was not recorded: %1.</source>
        <translation>无法记录这一帧：%1。</translation>
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
        <translation>恰在边上(&amp;T)</translation>
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
        <translation>恰在边上</translation>
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
        <source>recorded by edge equation: the same pixels as tiled</source>
        <translation>由边方程算法录制：像素与分块算法相同</translation>
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
    <message>
        <source>One step</source>
        <translation>一步</translation>
    </message>
    <message>
        <source>One row</source>
        <translation>一行</translation>
    </message>
    <message>
        <source>One face</source>
        <translation>一个面</translation>
    </message>
    <message>
        <source>One stage</source>
        <translation>一个阶段</translation>
    </message>
    <message>
        <source>To the start, the end</source>
        <translation>到开头、结尾</translation>
    </message>
    <message>
        <source>Slower, faster</source>
        <translation>更慢、更快</translation>
    </message>
    <message>
        <source>Play b&amp;y</source>
        <translation>播放方式(&amp;Y)</translation>
    </message>
    <message>
        <source>Geometry only</source>
        <translation>只有几何</translation>
    </message>
    <message>
        <source>Coverage only</source>
        <translation>只有覆盖</translation>
    </message>
    <message>
        <source>The selected pixel</source>
        <translation>选中的像素</translation>
    </message>
    <message>
        <source>Single step</source>
        <translation>单步</translation>
    </message>
    <message>
        <source>Sample</source>
        <translation>采样</translation>
    </message>
    <message>
        <source>Row, span</source>
        <translation>行、扫描段</translation>
    </message>
    <message>
        <source>Face</source>
        <translation>面</translation>
    </message>
    <message>
        <source>Stage</source>
        <translation>阶段</translation>
    </message>
    <message>
        <source>All of it in 5 seconds</source>
        <translation>全部在 5 秒内</translation>
    </message>
    <message>
        <source>All of it in 10 seconds</source>
        <translation>全部在 10 秒内</translation>
    </message>
    <message>
        <source>All of it in 30 seconds</source>
        <translation>全部在 30 秒内</translation>
    </message>
    <message>
        <source>All of it in 60 seconds</source>
        <translation>全部在 60 秒内</translation>
    </message>
    <message>
        <source>by step</source>
        <translation>逐步</translation>
    </message>
    <message>
        <source>by sample</source>
        <translation>逐采样</translation>
    </message>
    <message>
        <source>by row</source>
        <translation>逐行</translation>
    </message>
    <message>
        <source>by face</source>
        <translation>逐面</translation>
    </message>
    <message>
        <source>by stage</source>
        <translation>逐阶段</translation>
    </message>
    <message>
        <source>all in %1 s</source>
        <translation>全部 %1 秒</translation>
    </message>
    <message>
        <source>geometry</source>
        <translation>几何</translation>
    </message>
    <message>
        <source>coverage</source>
        <translation>覆盖</translation>
    </message>
    <message>
        <source>one pixel</source>
        <translation>一个像素</translation>
    </message>
    <message>
        <source>more than %1</source>
        <translation>%1 以上</translation>
    </message>
    <message>
        <source>recording the rest, then on …</source>
        <translation>录完其余部分后继续 …</translation>
    </message>
</context>
<context>
    <name>rasterlens::TruthMode</name>
    <message>
        <source>&amp;Exact referee</source>
        <translation>精确基准(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Next wrong pixel</source>
        <translation>下一个错误像素(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Wipe between A and B</source>
        <translation>A 与 B 卷帘对比(&amp;W)</translation>
    </message>
    <message>
        <source>&amp;Blink A and B</source>
        <translation>A 与 B 闪烁(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Difference of A and B</source>
        <translation>A 与 B 的差异(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Pin the present settings as A</source>
        <translation>把当前设置固定为 A(&amp;P)</translation>
    </message>
    <message>
        <source>E&amp;xchange A and B</source>
        <translation>交换 A 与 B(&amp;X)</translation>
    </message>
    <message>
        <source>&amp;Compare</source>
        <translation>比较(&amp;C)</translation>
    </message>
    <message>
        <source>Hard cases</source>
        <translation>疑难案例</translation>
    </message>
    <message>
        <source>Speed against error</source>
        <translation>速度与误差</translation>
    </message>
    <message>
        <source>&amp;Judge from object space</source>
        <translation>从物体空间判起(&amp;J)</translation>
    </message>
    <message>
        <source>Pin A, exchange A and B</source>
        <translation>固定 A，交换 A 与 B</translation>
    </message>
    <message>
        <source>Which mistake is mine?</source>
        <translation>我犯的是哪个错误？</translation>
    </message>
    <message>
        <source>Charts of errors</source>
        <translation>误差图表</translation>
    </message>
</context>
<context>
    <name>rasterlens::UnchangedNotes</name>
    <message>
        <source>changes nothing here: %1</source>
        <translation>在这里不起作用：%1</translation>
    </message>
    <message>
        <source>Whether a switch changes anything was not computed: %1.</source>
        <translation>没有算出开关是否起作用：%1。</translation>
    </message>
</context>
<context>
    <name>rasterlens::VertexPanel</name>
    <message>
        <source>Type over the blue numbers, or drag the corners on the canvas. Undo takes it back; the scene&apos;s file stays as it is.</source>
        <translation>可改写蓝色数字，或在画布上拖动顶点。可以撤销；场景文件不变。</translation>
    </message>
    <message>
        <source>Scenes of up to %1 faces can be edited here.</source>
        <translation>不超过 %1 个面的场景可以在这里编辑。</translation>
    </message>
    <message>
        <source>The corners of the face in every space</source>
        <translation>面的顶点在各个空间中的坐标</translation>
    </message>
    <message>
        <source>pixels</source>
        <translation>像素</translation>
    </message>
    <message>
        <source>clip</source>
        <translation>裁剪坐标</translation>
    </message>
    <message>
        <source>object</source>
        <translation>物体坐标</translation>
    </message>
    <message>
        <source>world</source>
        <translation>世界坐标</translation>
    </message>
    <message>
        <source>pixel grid</source>
        <translation>像素网格</translation>
    </message>
    <message>
        <source>pixel centre</source>
        <translation>像素中心</translation>
    </message>
    <message>
        <source>1/%1 pixel</source>
        <translation>1/%1 像素</translation>
    </message>
    <message>
        <source>A corner with w ≤ 0 lies behind the eye and has no place on the screen: type the coordinates that the scene gives.</source>
        <translation>w ≤ 0 的顶点在眼睛后面，在屏幕上没有位置：请输入场景给出的坐标。</translation>
    </message>
    <message>
        <source>Typed or dragged in pixels, a corner keeps its distance from the camera: depth and w stay.</source>
        <translation>按像素输入或拖动时，顶点到相机的距离不变：深度和 w 保持原样。</translation>
    </message>
    <message>
        <source>type in</source>
        <translation>输入</translation>
    </message>
    <message>
        <source>drag to</source>
        <translation>拖到</translation>
    </message>
    <message>
        <source>shared corners move together</source>
        <translation>公共顶点一起移动</translation>
    </message>
    <message>
        <source>What the numbers of a corner are that you type</source>
        <translation>输入的数是顶点的哪种坐标</translation>
    </message>
    <message>
        <source>The places that a dragged corner goes to</source>
        <translation>拖动的顶点落到哪里</translation>
    </message>
    <message>
        <source>Vertices of other faces that lie at the same place go with a corner</source>
        <translation>其他面在同一位置的顶点跟着一起移动</translation>
    </message>
</context>
<context>
    <name>rasterlens::VertexTableModel</name>
    <message>
        <source>inside</source>
        <translation>在内</translation>
    </message>
    <message>
        <source>Double-click to type other numbers</source>
        <translation>双击可输入其他数字</translation>
    </message>
    <message>
        <source>given  x, y, z, w</source>
        <translation>给定  x, y, z, w</translation>
    </message>
    <message>
        <source>object  x, y, z</source>
        <translation>物体  x, y, z</translation>
    </message>
    <message>
        <source>view  x, y, z</source>
        <translation>视图  x, y, z</translation>
    </message>
    <message>
        <source>clip  x, y, z, w</source>
        <translation>裁剪  x, y, z, w</translation>
    </message>
    <message>
        <source>NDC  clip / w</source>
        <translation>NDC  裁剪 / w</translation>
    </message>
    <message>
        <source>screen  pixels</source>
        <translation>屏幕  像素</translation>
    </message>
    <message>
        <source>snapped  pixels</source>
        <translation>对齐后  像素</translation>
    </message>
    <message>
        <source>depth  0..1</source>
        <translation>深度  0..1</translation>
    </message>
    <message>
        <source>outside of</source>
        <translation>在其外侧</translation>
    </message>
    <message>
        <source>%1, vertex %2</source>
        <translation>%1，顶点 %2</translation>
    </message>
    <message>
        <source>outcode</source>
        <translation>区域编码</translation>
    </message>
    <message>
        <source>One bit each: above, below, right, left of the screen</source>
        <translation>各占一位：屏幕的上、下、右、左</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a position. Write x, y, z, w or x, y, z.</source>
        <translation>&quot;%1&quot; 不是位置。请写 x, y, z, w 或 x, y, z。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a position. Write x, y, z.</source>
        <translation>&quot;%1&quot; 不是位置。请写 x, y, z。</translation>
    </message>
    <message>
        <source>world  x, y, z</source>
        <translation>世界  x, y, z</translation>
    </message>
    <message>
        <source>Behind the eye a corner has no place on the screen.</source>
        <translation>在眼睛后面的顶点在屏幕上没有位置。</translation>
    </message>
    <message>
        <source>colour  r, g, b</source>
        <translation>颜色  r, g, b</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a place on the screen. Write x, y in pixels.</source>
        <translation>&quot;%1&quot; 不是屏幕上的位置。请写以像素为单位的 x, y。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a colour. Write r, g, b from 0 to 1, or #rrggbb.</source>
        <translation>&quot;%1&quot; 不是颜色。请写 0 到 1 的 r, g, b，或者 #rrggbb。</translation>
    </message>
</context>
<context>
    <name>rasterlens::ViewportWidget</name>
    <message>
        <source>former picture</source>
        <translation>先前的图像</translation>
    </message>
</context>
<context>
    <name>rasterlens::ViewsBar</name>
    <message>
        <source>Difference</source>
        <translation>差异</translation>
    </message>
    <message>
        <source>Overlays</source>
        <translation>叠加</translation>
    </message>
    <message>
        <source>What is laid over the picture</source>
        <translation>叠加在画面上的内容</translation>
    </message>
    <message>
        <source>What the canvas shows</source>
        <translation>画布显示的内容</translation>
    </message>
    <message>
        <source>View</source>
        <translation>视图</translation>
    </message>
    <message>
        <source>What the canvas shows, and what is laid over it</source>
        <translation>画布显示与叠加的内容</translation>
    </message>
    <message>
        <source>More</source>
        <translation>更多</translation>
    </message>
</context>
<context>
    <name>HandoutExport</name>
    <message>
        <source>Handout of a lesson</source>
        <translation>课程讲义</translation>
    </message>
    <message>
        <source>Lesson:</source>
        <translation>课程：</translation>
    </message>
</context>
<context>
    <name>rasterlens::FigureExport</name>
    <message>
        <source>%1 could not be written: %2</source>
        <translation>无法写入 %1：%2</translation>
    </message>
    <message>
        <source>edge %1</source>
        <translation>边 %1</translation>
    </message>
    <message>
        <source>inside of the edge</source>
        <translation>在边的内侧</translation>
    </message>
    <message>
        <source>outside</source>
        <translation>在外侧</translation>
    </message>
    <message>
        <source>on the edge: a tie</source>
        <translation>恰在边上</translation>
    </message>
    <message>
        <source>sample</source>
        <translation>采样点</translation>
    </message>
    <message>
        <source>pixel (%1, %2)</source>
        <translation>像素 (%1, %2)</translation>
    </message>
    <message>
        <source>Step %1 of %2</source>
        <translation>第 %1 步，共 %2 步</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>正确</translation>
    </message>
    <message>
        <source>With the mistake</source>
        <translation>有错误</translation>
    </message>
</context>
<context>
    <name>rasterlens::IdentifyPanel</name>
    <message>
        <source>The right picture</source>
        <translation>正确的图片</translation>
    </message>
    <message>
        <source>The picture cannot be compared: %1.</source>
        <translation>无法比较这张图片：%1。</translation>
    </message>
    <message>
        <source>The present settings cannot be drawn, so that there is nothing to compare with.</source>
        <translation>当前设置无法绘制，因此没有可供比较的图片。</translation>
    </message>
    <message>
        <source>%1, together with %2</source>
        <translation>%1，以及 %2</translation>
    </message>
    <message>
        <source>Draws the same picture here:</source>
        <translation>在这里画出同一张图片的还有：</translation>
    </message>
    <message>
        <source>Yours</source>
        <translation>你的图片</translation>
    </message>
    <message>
        <source>With the mistake</source>
        <translation>有错误</translation>
    </message>
    <message>
        <source>Where they differ</source>
        <translation>不同之处</translation>
    </message>
    <message>
        <source>Comparing with each mistake…</source>
        <translation>正在与每个错误比较…</translation>
    </message>
    <message>
        <source>Drop a picture that your own program drew of this scene, or choose it: it is compared with the right picture and with what each mistake draws.</source>
        <translation>把你自己的程序为这个场景画的图片拖进来，或选择它：它会与正确的图片以及每个错误画出的图片比较。</translation>
    </message>
    <message>
        <source>%1: none of these. No mistake explains the picture.</source>
        <translation>%1：都不是。没有一个错误能解释这张图片。</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Choose a picture…</source>
        <translation>选择图片…</translation>
    </message>
    <message>
        <source>The scene or its settings have changed since.</source>
        <translation>此后场景或设置已改变。</translation>
    </message>
    <message>
        <source>Compare again</source>
        <translation>重新比较</translation>
    </message>
    <message>
        <source>Show in the window</source>
        <translation>在窗口中显示</translation>
    </message>
    <message>
        <source>Switches this mistake on; a double click does so as well</source>
        <translation>打开这个错误；双击也可以</translation>
    </message>
    <message>
        <source>Fits</source>
        <translation>符合</translation>
    </message>
    <message>
        <source>Mistake</source>
        <translation>错误</translation>
    </message>
    <message>
        <source>Pixels</source>
        <translation>像素</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>It was compared with what the window showed, which is not the view that the scene asks for.</source>
        <translation>与它比较的是窗口当时显示的视图，而不是场景要求的视图。</translation>
    </message>
</context>
<context>
    <name>rasterlens::LightFields</name>
    <message>
        <source>&quot;%1&quot; is no direction. Write three numbers x, y, z that are not all 0.</source>
        <translation>&quot;%1&quot; 不是方向。请写出三个不全为 0 的数 x, y, z。</translation>
    </message>
    <message>
        <source>Towards the light</source>
        <translation>指向光源</translation>
    </message>
    <message>
        <source>The direction from the scene to the light: x, y, z in world space. Its length does not matter.</source>
        <translation>从场景指向光源的方向：世界空间中的 x, y, z。长度无关紧要。</translation>
    </message>
    <message>
        <source>Headlight</source>
        <translation>头灯</translation>
    </message>
    <message>
        <source>The light shines along the camera&apos;s view and turns with it.</source>
        <translation>光沿着相机的视线照射，并随相机转动。</translation>
    </message>
    <message>
        <source>Drag the bright side of the ball. With Shift the light comes from behind it.</source>
        <translation>拖动球的亮面。按住 Shift 时，光从球的后面照来。</translation>
    </message>
    <message>
        <source>Put back what the scene asks for</source>
        <translation>恢复场景要求的值</translation>
    </message>
</context>
<context>
    <name>rasterlens::NumbersRow</name>
    <message>
        <source>Put back what the scene asks for</source>
        <translation>恢复场景要求的值</translation>
    </message>
</context>
<context>
    <name>Chart</name>
    <message>
        <source>What snapping does to faces</source>
        <translation>对齐对面的影响</translation>
    </message>
    <message>
        <source>Corners snap to 1/2^bits of a pixel: a corner may pass to the other side of the opposite edge, and its face then looks the other way.</source>
        <translation>顶点对齐到 1/2^bits 像素：顶点可能越过对边，面于是翻转朝向。</translation>
    </message>
    <message>
        <source>subpixel bits</source>
        <translation>亚像素位数</translation>
    </message>
    <message>
        <source>% of the faces</source>
        <translation>占面的 %</translation>
    </message>
    <message>
        <source>How near is too near for the depth buffer</source>
        <translation>对深度缓冲来说多近算太近</translation>
    </message>
    <message>
        <source>The farther away, the coarser: so far two surfaces have to be apart to be stored as different depths.</source>
        <translation>越远越粗：两个表面要相距这么远，存下的深度才不同。</translation>
    </message>
    <message>
        <source>distance from the eye</source>
        <translation>到眼睛的距离</translation>
    </message>
    <message>
        <source>step of depth, as a distance</source>
        <translation>一级深度对应的距离</translation>
    </message>
    <message>
        <source>Edge functions in floating point</source>
        <translation>浮点边函数</translation>
    </message>
    <message>
        <source>Samples near an edge that come out on the wrong side, against exact integers.</source>
        <translation>边附近被判到错误一侧的采样，以精确整数为准。</translation>
    </message>
    <message>
        <source>largest coordinate, pixels</source>
        <translation>最大坐标，像素</translation>
    </message>
    <message>
        <source>wrong samples in a million</source>
        <translation>每百万采样中的错误数</translation>
    </message>
    <message>
        <source>Line rules against the true line</source>
        <translation>线规则与真实直线</translation>
    </message>
    <message>
        <source>Pixels that a rule has and the diamonds of the true line do not give, or the other way round.</source>
        <translation>规则画了而真实直线的菱形没有给出的像素，或者相反。</translation>
    </message>
    <message>
        <source>angle, degrees</source>
        <translation>角度，度</translation>
    </message>
    <message>
        <source>% of the line&apos;s pixels</source>
        <translation>占线的像素的 %</translation>
    </message>
    <message>
        <source>What it costs not to divide</source>
        <translation>不做除法的代价</translation>
    </message>
    <message>
        <source>A colour from 0 to 1 along 256 pixels whose ends are not equally far away; dividing every 8 or 16 pixels was the trade of early games.</source>
        <translation>颜色沿 256 个像素由 0 到 1，两端远近不同；每 8 或 16 像素除一次是早期游戏的折中。</translation>
    </message>
    <message>
        <source>ratio of the distances</source>
        <translation>距离之比</translation>
    </message>
    <message>
        <source>largest error, 8-bit steps</source>
        <translation>最大误差，8 位级</translation>
    </message>
    <message>
        <source>Samples against the covered area</source>
        <translation>采样与覆盖面积</translation>
    </message>
    <message>
        <source>How well the samples of grids and patterns tell what part of a pixel is covered.</source>
        <translation>网格和图案的采样能多准地反映像素被覆盖的部分。</translation>
    </message>
    <message>
        <source>samples a pixel</source>
        <translation>每像素采样数</translation>
    </message>
    <message>
        <source>rms error, areas of a pixel</source>
        <translation>均方根误差，像素面积</translation>
    </message>
    <message>
        <source>The scene far from the origin</source>
        <translation>远离原点的场景</translation>
    </message>
    <message>
        <source>Wrong pixels as the scene is moved away from 0, with positions held as files are read and as float32 from 0.</source>
        <translation>场景移离 0 时的错误像素，位置分别按读文件时的方式和从 0 起的 float32 保存。</translation>
    </message>
    <message>
        <source>distance from 0</source>
        <translation>到 0 的距离</translation>
    </message>
    <message>
        <source>wrong pixels</source>
        <translation>错误像素</translation>
    </message>
    <message>
        <source>%1 is given in clip space and has no camera; a scene in object space is expected</source>
        <translation>%1 以裁剪空间给出，没有相机；需要物体空间的场景</translation>
    </message>
    <message>
        <source>turned over</source>
        <translation>翻转</translation>
    </message>
    <message>
        <source>without area</source>
        <translation>面积为零</translation>
    </message>
    <message>
        <source>folded, of those that were cut</source>
        <translation>折叠（占被裁剪的面）</translation>
    </message>
    <message>
        <source>%1 faces in the view volume, %2 of them cut by its planes.</source>
        <translation>视景体中有 %1 个面，其中 %2 个被其平面裁剪。</translation>
    </message>
    <message>
        <source>float32</source>
        <translation>float32</translation>
    </message>
    <message>
        <source>float32, reversed</source>
        <translation>float32，反向</translation>
    </message>
    <message>
        <source>unorm24</source>
        <translation>unorm24</translation>
    </message>
    <message>
        <source>unorm16</source>
        <translation>unorm16</translation>
    </message>
    <message>
        <source>unorm24 by d² (f - n) / (f n) / 2^24</source>
        <translation>unorm24，按 d² (f - n) / (f n) / 2^24</translation>
    </message>
    <message>
        <source>unorm16 by d² (f - n) / (f n) / 2^16</source>
        <translation>unorm16，按 d² (f - n) / (f n) / 2^16</translation>
    </message>
    <message>
        <source>Near and far of the camera: %1 and %2.</source>
        <translation>相机的近、远平面：%1 和 %2。</translation>
    </message>
    <message>
        <source>No perspective camera here: near and far are %1 and %2.</source>
        <translation>这里没有透视相机：近、远平面取 %1 和 %2。</translation>
    </message>
    <message>
        <source>Where a curve ends, everything up to far is stored as one depth.</source>
        <translation>曲线终止处，直到远平面都存为同一个深度。</translation>
    </message>
    <message>
        <source>float32, added up</source>
        <translation>float32，逐步累加</translation>
    </message>
    <message>
        <source>float32, added up with compensation (Kahan)</source>
        <translation>float32，补偿累加（Kahan）</translation>
    </message>
    <message>
        <source>float32, anew at every sample</source>
        <translation>float32，每个采样重新计算</translation>
    </message>
    <message>
        <source>float32, from the same end for both faces</source>
        <translation>float32，两个面都从同一端计算</translation>
    </message>
    <message>
        <source>float64</source>
        <translation>float64</translation>
    </message>
    <message>
        <source>%1 random edges a size, half of them between halves of pixels; samples within %2 pixels of them, in up to %3 rows each.</source>
        <translation>每种大小 %1 条随机边，其中一半连接半像素点；取距边 %2 像素以内的采样，每条至多 %3 行。</translation>
    </message>
    <message>
        <source>From the same end for both faces the values are wrong as often, but the two faces at an edge never disagree.</source>
        <translation>两个面都从同一端计算时，出错同样多，但边两侧的面绝不会不一致。</translation>
    </message>
    <message>
        <source>both ends, Bresenham</source>
        <translation>含两端，Bresenham</translation>
    </message>
    <message>
        <source>both ends, DDA</source>
        <translation>含两端，DDA</translation>
    </message>
    <message>
        <source>without the last, Bresenham</source>
        <translation>不含末端，Bresenham</translation>
    </message>
    <message>
        <source>diamond exit</source>
        <translation>离开菱形</translation>
    </message>
    <message>
        <source>%1 lines of %2 pixels an angle, their ends anywhere in a pixel.</source>
        <translation>每个角度 %1 条长 %2 像素的线，端点在像素内任意处。</translation>
    </message>
    <message>
        <source>Lines from pixel to pixel lie up to half a pixel beside the edge that they stand for; the diamonds go by the edge.</source>
        <translation>从像素到像素的线可能偏离所代表的边至多半个像素；菱形以边本身为准。</translation>
    </message>
    <message>
        <source>affine</source>
        <translation>仿射</translation>
    </message>
    <message>
        <source>divided every 16 pixels</source>
        <translation>每 16 像素除一次</translation>
    </message>
    <message>
        <source>divided every 8 pixels</source>
        <translation>每 8 像素除一次</translation>
    </message>
    <message>
        <source>perspective, float32</source>
        <translation>透视，float32</translation>
    </message>
    <message>
        <source>A division a pixel, one every 16 or 8, or none: 256, 17, 33 and 0 on this row.</source>
        <translation>每像素一次除法、每 16 或 8 像素一次，或没有：这一行上分别是 256、17、33 和 0 次。</translation>
    </message>
    <message>
        <source>Half a step is what a picture of 8 bits can show.</source>
        <translation>半级是 8 位图片能显示的极限。</translation>
    </message>
    <message>
        <source>grids</source>
        <translation>网格</translation>
    </message>
    <message>
        <source>patterns of MSAA</source>
        <translation>MSAA 图案</translation>
    </message>
    <message>
        <source>%1 pixels are covered in part.</source>
        <translation>%1 个像素被部分覆盖。</translation>
    </message>
    <message>
        <source>as files are read, from an origin of the mesh</source>
        <translation>按读文件时的方式，从网格自己的原点</translation>
    </message>
    <message>
        <source>float32 from 0</source>
        <translation>从 0 起的 float32</translation>
    </message>
</context>
<context>
    <name>rasterlens::ChartPanel</name>
    <message>
        <source>There is not enough memory for this chart.</source>
        <translation>内存不足，无法绘制此图表。</translation>
    </message>
    <message>
        <source>The system does not start so many threads.</source>
        <translation>系统无法启动这么多线程。</translation>
    </message>
    <message>
        <source>The scene or its settings have changed since.</source>
        <translation>此后场景或设置已改变。</translation>
    </message>
    <message>
        <source>Being drawn …</source>
        <translation>正在绘制……</translation>
    </message>
    <message>
        <source>Export the chart</source>
        <translation>导出图表</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>已写入：%1</translation>
    </message>
    <message>
        <source>Chart</source>
        <translation>图表</translation>
    </message>
    <message>
        <source>Draw again</source>
        <translation>重新绘制</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>导出</translation>
    </message>
</context>
<context>
    <name>Motion</name>
    <message>
        <source>Turntable</source>
        <translation>转台</translation>
    </message>
    <message>
        <source>Jitter by 1/256 pixel</source>
        <translation>按 1/256 像素抖动</translation>
    </message>
</context>
<context>
    <name>rasterlens::MotionMode</name>
    <message>
        <source>The motion ended: %1.</source>
        <translation>运动已停止：%1。</translation>
    </message>
    <message>
        <source>Turntable, frame %1: turned by %2°</source>
        <translation>转台，第 %1 帧：转过 %2°</translation>
    </message>
    <message>
        <source>Jitter, frame %1: %2/256 pixel to the right</source>
        <translation>抖动，第 %1 帧：向右 %2/256 像素</translation>
    </message>
    <message>
        <source>pixels changed since the last frame: %1, to another face: %2</source>
        <translation>与上一帧不同的像素：%1，其中换了面：%2</translation>
    </message>
    <message>
        <source>%1 a frame on average</source>
        <translation>平均每帧 %1</translation>
    </message>
</context>
<context>
    <name>rasterlens::TexelPlate</name>
    <message>
        <source>level %1 (%2 x %3), %4 %: %5</source>
        <translation>级别 %1（%2 x %3），%4 %：%5</translation>
    </message>
    <message>
        <source>drawn on level %1</source>
        <translation>画在级别 %1 上</translation>
    </message>
    <message>
        <source>no texel is read: the level itself is shown</source>
        <translation>没有读取纹素：显示的是级别本身</translation>
    </message>
    <message>
        <source>Footprint in the texture (%1 x %2)</source>
        <translation>在纹理中的足迹（%1 x %2）</translation>
    </message>
</context>
<context>
    <name>rasterlens::HelpOverlay</name>
    <message>
        <source>Page %1 of %2 · F1: the next one</source>
        <translation>第 %1 页，共 %2 页 · F1：下一页</translation>
    </message>
</context>
<context>
    <name>OutsideQuestion</name>
    <message>
        <source>and %1 more</source>
        <translation>还有 %1 个</translation>
    </message>
    <message>
        <source>&amp;Read them</source>
        <translation>读取(&amp;R)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; names files outside its folder. Read them?</source>
        <translation>“%1”引用了所在文件夹之外的文件。要读取它们吗？</translation>
    </message>
    <message>
        <source>&amp;Do not read them</source>
        <translation>不读取(&amp;D)</translation>
    </message>
</context>
</TS>
