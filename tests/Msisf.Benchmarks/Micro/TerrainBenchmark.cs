using BenchmarkDotNet.Attributes;
using Msisf.Adapters.Raster.Heights;
using Msisf.Adapters.Tiles;
using Msisf.Benchmarks.Definitions;
using Msisf.Benchmarks.Programs;
using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Surface;
using Msisf.Core.Tiles;
using Msisf.Core.Tiles.Selection;
using Msisf.Core.Tracing;
using CellBlock = Msisf.Core.Surface.CellBlock;

namespace Msisf.Benchmarks.Micro;

/// <summary>What works on the elevation model, on LDEM_4 and its far scene.</summary>
public class TerrainBenchmark
{
    private const int PrimeStep = 7919; // px: neighbouring calls have pixels far apart

    private readonly Scene _scene = Scenes.Named("far-4");
    private readonly BlockVertices _vertices = new();
    private LdemImage _model = null!;
    private Dspsa _selection = null!;
    private SurfaceModel _surface = null!;
    private TerrainTracer _tracer = null!;
    private TileMesh _mesh = null!;
    private Vector3D _sun;
    private int _pixel;

    [GlobalSetup]
    public void Open()
    {
        _model = LdemImage.Open(LdemCatalog.Read(Path.Combine("input", "ldem", "LDEM_4.LBL")));
        _selection = new Dspsa(_model);
        _surface = new SurfaceModel(_model);
        _tracer = new TerrainTracer(_model);
        TileMeshBuilder builder = new(_model);
        TileMeshLayout layout = TileMeshLayout.For(new TileId(0, 45), _model.PixelsPerDegree);
        _mesh = builder.Build(layout, builder.ReadRadii(layout));
        using Sun sun = Sun.Open(Environment.CurrentDirectory);
        _sun = sun.Ephemeris.SunPositionBodyFixed(_scene.State.Time);
    }

    [GlobalCleanup]
    public void Close() => _model.Dispose();

    /// <summary>The tiles of an image.</summary>
    [Benchmark]
    public TileSelection Selection() => _selection.Select(_scene.Camera, _sun);

    /// <summary>The text of a tile's pattern.</summary>
    [Benchmark]
    public long Pattern()
    {
        using MemoryStream text = new();
        PatternWriter.Write(text, _mesh, _model.ProductId, PatternFormat.Mesh2);
        return text.Length;
    }

    /// <summary>The vertices of a block of 32 x 32 cells.</summary>
    [Benchmark]
    public double BlockOfVertices()
    {
        _vertices.Load(_surface, new CellBlock(361 / CellBlock.Size, 180 / CellBlock.Size), _scene.State.PositionBodyFixed);
        return _vertices.X[0];
    }

    /// <summary>One pixel by the exact tracer, without its shadow.</summary>
    [Benchmark]
    public SurfaceHit TracedRay()
    {
        PinholeCamera camera = _scene.Camera;
        _pixel = (_pixel + PrimeStep) % (_scene.Side * _scene.Side);
        _tracer.TryTrace(camera.RayThrough(1 + (_pixel % _scene.Side), 1 + (_pixel / _scene.Side)), out SurfaceHit hit);
        return hit;
    }
}
