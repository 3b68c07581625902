using System.Collections;
using System.Data.Common;

namespace MySqlConnector;

internal sealed class FakeParameters : DbParameterCollection
{
    private readonly List<FakeParameter> _items = [];

    public override int Count => _items.Count;

    public override object SyncRoot => _items;

    public IReadOnlyDictionary<string, object> Values => _items.ToDictionary(item => item.ParameterName, item => item.Value!);

    public override int Add(object value)
    {
        _items.Add((FakeParameter)value);
        return _items.Count - 1;
    }

    public override void AddRange(Array values) => throw new NotSupportedException();

    public override void Clear() => _items.Clear();

    public override bool Contains(object value) => _items.Contains((FakeParameter)value);

    public override bool Contains(string value) => IndexOf(value) >= 0;

    public override void CopyTo(Array array, int index) => ((ICollection)_items).CopyTo(array, index);

    public override IEnumerator GetEnumerator() => _items.GetEnumerator();

    public override int IndexOf(object value) => _items.IndexOf((FakeParameter)value);

    public override int IndexOf(string parameterName) => _items.FindIndex(item => item.ParameterName == parameterName);

    public override void Insert(int index, object value) => _items.Insert(index, (FakeParameter)value);

    public override void Remove(object value) => _items.Remove((FakeParameter)value);

    public override void RemoveAt(int index) => _items.RemoveAt(index);

    public override void RemoveAt(string parameterName) => RemoveAt(IndexOf(parameterName));

    protected override DbParameter GetParameter(int index) => _items[index];

    protected override DbParameter GetParameter(string parameterName) => _items[IndexOf(parameterName)];

    protected override void SetParameter(int index, DbParameter value) => _items[index] = (FakeParameter)value;

    protected override void SetParameter(string parameterName, DbParameter value) => _items[IndexOf(parameterName)] = (FakeParameter)value;
}
